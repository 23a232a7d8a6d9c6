// SPDX-License-Identifier: MIT
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// A face of the part of an element that a virtual-node copy holds: a convex polygon, counter-clockwise
/// seen from outside.
struct ClippedFace {
    std::vector<Eigen::Vector4d> weights; // barycentric coordinates of its vertices
    int face = -1;                        // of the element that it lies in; -1: in a crack
};

/// What bounds the matter of a copy: its tetrahedron, cut by each crack that separates its real corners
/// from others that the cracks before it had left together with them.
std::vector<ClippedFace> clipped_element(const Deformable& solid, int element);

/// What of a convex polygon in a face of an element another one there leaves open, in convex pieces. Less
/// than 1e-12 of the face is nothing.
///
/// @param polygon, cover  barycentric coordinates of their vertices in the same element
std::vector<std::vector<Eigen::Vector4d>> uncovered(std::vector<Eigen::Vector4d> polygon,
                                                    const std::vector<Eigen::Vector4d>& cover,
                                                    int face);

} // namespace rigor
