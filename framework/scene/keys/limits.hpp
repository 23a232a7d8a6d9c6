// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace rigor {

/// Larger scenes are refused: the limits guard against a scene file of a few kilobytes that uses
/// all memory of the machine.
constexpr std::size_t most_bodies = 100'000, most_shapes = 200'000;
constexpr std::size_t most_scene_tetrahedra = 200'000;

} // namespace rigor
