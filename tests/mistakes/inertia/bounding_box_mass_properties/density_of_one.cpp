// SPDX-License-Identifier: MIT
// The volume of the box is taken for its mass.
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
    const Vector3d squares = (high - low).cwiseAbs2();
    const double M = (high - low).prod();
    const Vector3d I = M / 12 * (squares.sum() * Vector3d::Ones() - squares);
    return {M, (low + high) / 2, I.asDiagonal()};
}

} // namespace rigor
