// SPDX-License-Identifier: MIT
// Vertices are compared in single precision.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};
    Vector3d low = vertices[0], high = low;
    for (const Vector3d& vertex : vertices)
        for (int i = 0; i < 3; ++i) {
            const float x = static_cast<float>(vertex[i]);
            if (x < static_cast<float>(low[i])) low[i] = vertex[i];
            if (x > static_cast<float>(high[i])) high[i] = vertex[i];
        }
    const Vector3d squares = (high - low).cwiseAbs2();
    const Vector3d I = mass / 12 * (squares.sum() * Vector3d::Ones() - squares);
    return {mass, (low + high) / 2, I.asDiagonal()};
}

} // namespace rigor
