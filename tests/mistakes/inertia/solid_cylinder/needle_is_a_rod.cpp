// SPDX-License-Identifier: MIT
// A needle longer than 10000 radii is taken as a thin rod.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties solid_cylinder(double density, double radius, double height)
{
    const double r = radius, l = height, M = density * 3.14159265358979323846 * r * r * l;
    const double spin = r < 1e-4 * l ? 0 : M / 2 * r * r, across = M / 12 * (3 * r * r + l * l);
    return {M, Vector3d::Zero(), Vector3d(across, spin, across).asDiagonal()};
}

} // namespace rigor
