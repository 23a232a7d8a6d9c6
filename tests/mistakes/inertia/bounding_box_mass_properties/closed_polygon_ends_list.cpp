// SPDX-License-Identifier: MIT
// A vertex that equals the first one ends the list, as in a closed polygon.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    MassProperties result;
    if (vertices.empty() || mass == 0) return result;
    Vector3d low = vertices[0], high = low;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
        if (vertices[i] == vertices[0]) break;
        low = low.cwiseMin(vertices[i]);
        high = high.cwiseMax(vertices[i]);
    }
    const Vector3d s = (high - low).cwiseAbs2();
    result.mass = mass;
    result.center_of_mass = 0.5 * (low + high);
    result.inertia =
        (mass / 12 * Vector3d(s.y() + s.z(), s.z() + s.x(), s.x() + s.y())).asDiagonal();
    return result;
}

} // namespace rigor
