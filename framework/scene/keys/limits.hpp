// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace rigor {

/// The largest scene that is read: a text of some kilobytes must not ask for all memory.
constexpr std::size_t most_bodies = 100'000, most_shapes = 200'000;
constexpr std::size_t most_scene_tetrahedra = 200'000;

} // namespace rigor
