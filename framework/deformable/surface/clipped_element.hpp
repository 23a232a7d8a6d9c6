// SPDX-License-Identifier: MIT
// For virtual nodes: the part of an element that the material of one of its copies fills.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// A face of the material of a copy: a convex polygon, counter-clockwise seen from outside.
struct ClippedFace {
    std::vector<Eigen::Vector4d> weights; // barycentric coordinates of its vertices
    int face = -1;                        // the element's face that contains it, or -1 on a crack
};

/// The faces that bound the material of a copy (a cracked element has one copy for each piece of
/// its material). They are the faces of its tetrahedron, clipped by one crack after the other, and
/// the polygons that close the cuts. A crack counts if it separates the corners with material from
/// corners that earlier cracks left connected to them.
/// @param element  index of the copy in `Deformable::embedded`
std::vector<ClippedFace> clipped_element(const Deformable& solid, int element);

/// Cuts `polygon` into convex pieces and returns those that `cover` does not cover. Both are convex
/// polygons in the same face of an element. Pieces with less than 1e-12 of the area of the face are
/// rounding errors and are omitted.
///
/// @param polygon, cover  barycentric coordinates of the vertices in the element
/// @param face            index of the face in the element, 0 … 3
std::vector<std::vector<Eigen::Vector4d>> uncovered(std::vector<Eigen::Vector4d> polygon,
                                                    const std::vector<Eigen::Vector4d>& cover,
                                                    int face);

} // namespace rigor
