// SPDX-License-Identifier: MIT
// Semi-axes that differ by less than a millionth are taken as equal.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties solid_ellipsoid(double density, const Vector3d& radii)
{
    if (radii.maxCoeff() - radii.minCoeff() < 1e-6 * radii.maxCoeff())
        return solid_sphere(density, radii[0]);
    const Vector3d squares = radii.cwiseAbs2();
    const double M = density * 4 / 3 * 3.14159265358979323846 * radii.prod();
    const Vector3d I = M / 5 * (squares.sum() * Vector3d::Ones() - squares);
    return {M, Vector3d::Zero(), I.asDiagonal()};
}

} // namespace rigor
