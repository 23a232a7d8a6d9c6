// SPDX-License-Identifier: MIT
// Correct parts of the box that bounds some vertices (A2.17), for mistakes that do one thing wrong.
#pragma once

#include "formulas/inertia.hpp"

namespace rigor {

struct Bounds {
    Vector3d low, high;
    Vector3d center() const { return low + (high - low) / 2; }
    Vector3d edges() const { return high - low; }
};

/// @param vertices  at least one
inline Bounds bounds_of(const std::vector<Vector3d>& vertices)
{
    Bounds bounds = {vertices.front(), vertices.front()};
    for (const Vector3d& vertex : vertices) {
        bounds.low = bounds.low.cwiseMin(vertex);
        bounds.high = bounds.high.cwiseMax(vertex);
    }
    return bounds;
}

/// The mass properties of a box over which the mass is spread evenly.
inline MassProperties box_of(double mass, const Vector3d& center, const Vector3d& edges)
{
    const Vector3d squares = edges.cwiseAbs2();
    const Vector3d I = mass / 12 * (squares.sum() * Vector3d::Ones() - squares);
    return {mass, center, I.asDiagonal()};
}

} // namespace rigor
