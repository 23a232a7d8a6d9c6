// SPDX-License-Identifier: MIT
// The connected pieces of a solid.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// For each element, the index of the piece that contains it, counted from 0. Elements that share a
/// vertex are in the same piece.
std::vector<int> pieces(const Deformable& solid);

} // namespace rigor
