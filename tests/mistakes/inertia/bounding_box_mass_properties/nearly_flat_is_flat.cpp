// SPDX-License-Identifier: MIT
// An edge of less than a hundred-thousandth of the longest one counts as 0.
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
    Vector3d edges = high - low;
    for (double& edge : edges)
        if (edge < 1e-5 * (high - low).maxCoeff()) edge = 0;
    const Vector3d squares = edges.cwiseAbs2();
    const Vector3d I = mass / 12 * (squares.sum() * Vector3d::Ones() - squares);
    return {mass, low + (high - low) / 2, I.asDiagonal()};
}

} // namespace rigor
