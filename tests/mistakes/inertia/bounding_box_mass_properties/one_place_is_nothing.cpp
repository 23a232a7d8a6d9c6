// SPDX-License-Identifier: MIT
// Several vertices in one place count as no vertices.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};
    Vector3d low = vertices.front(), high = low;
    for (const Vector3d& vertex : vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    if (vertices.size() > 1 && low == high) return {};
    const Vector3d squares = (high - low).cwiseAbs2();
    const Vector3d I = mass / 12 * (squares.sum() * Vector3d::Ones() - squares);
    return {mass, low + (high - low) / 2, I.asDiagonal()};
}

} // namespace rigor
