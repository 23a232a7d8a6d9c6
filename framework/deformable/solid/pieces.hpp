// SPDX-License-Identifier: MIT
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// Of each element, the number of the piece that it belongs to, from 0. Elements of a piece hang
/// together by vertices.
std::vector<int> pieces(const Deformable& solid);

} // namespace rigor
