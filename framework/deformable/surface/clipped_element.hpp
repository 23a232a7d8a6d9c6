// SPDX-License-Identifier: MIT
// The part of an element that the matter of a virtual-node copy fills.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// A face of the part of an element that a virtual-node copy holds: a convex polygon,
/// counter-clockwise seen from outside.
struct ClippedFace {
    std::vector<Eigen::Vector4d> weights; // barycentric coordinates of its vertices
    int face = -1;                        // the face of the element that contains it; -1: a crack
};

/// The faces that bound the matter of a copy. They come from its tetrahedron, cut in turn by each
/// crack that separates its real corners from corners which earlier cracks had left connected to
/// them.
std::vector<ClippedFace> clipped_element(const Deformable& solid, int element);

/// The part of a convex polygon that another one in the same face of an element does not cover, in
/// convex pieces. Pieces below 1e-12 of the area of the face are rounding and left out.
///
/// @param polygon, cover  barycentric coordinates of their vertices in the same element
std::vector<std::vector<Eigen::Vector4d>> uncovered(std::vector<Eigen::Vector4d> polygon,
                                                    const std::vector<Eigen::Vector4d>& cover,
                                                    int face);

} // namespace rigor
