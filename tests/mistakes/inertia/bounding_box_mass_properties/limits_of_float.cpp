// SPDX-License-Identifier: MIT
// The search for the bounds starts at the largest numbers of single precision. Vertices may be
// farther out.
#include "formulas/inertia.hpp"

#include <limits>

namespace rigor {

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};
    Vector3d low = Vector3d::Constant(std::numeric_limits<float>::max()), high = -low;
    for (const Vector3d& vertex : vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    const Vector3d squares = (high - low).cwiseAbs2();
    const Vector3d I = mass / 12 * (squares.sum() * Vector3d::Ones() - squares);
    return {mass, (low + high) / 2, I.asDiagonal()};
}

} // namespace rigor
