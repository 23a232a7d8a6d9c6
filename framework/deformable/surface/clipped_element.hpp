// SPDX-License-Identifier: MIT
// The part of an element that the material of a copy fills, for virtual nodes.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// A face of the material of a copy: a convex polygon, counter-clockwise seen from outside.
struct ClippedFace {
    std::vector<Eigen::Vector4d> weights; // barycentric coordinates of its vertices
    int face = -1;                        // face of the element that contains it, -1 for a crack
};

/// The faces that bound the material of a copy. They are the faces of its tetrahedron, clipped by
/// one crack after the other, and the polygons that close the cuts. A crack counts if it separates
/// the real corners from corners that earlier cracks left connected to them.
std::vector<ClippedFace> clipped_element(const Deformable& solid, int element);

/// The part of a convex polygon that another polygon in the same face of an element does not cover,
/// as convex pieces. Pieces with less than 1e-12 of the area of the face are rounding errors and
/// are omitted.
///
/// @param polygon, cover  barycentric coordinates of the vertices in the same element
std::vector<std::vector<Eigen::Vector4d>> uncovered(std::vector<Eigen::Vector4d> polygon,
                                                    const std::vector<Eigen::Vector4d>& cover,
                                                    int face);

} // namespace rigor
