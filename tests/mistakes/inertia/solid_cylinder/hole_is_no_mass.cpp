// SPDX-License-Identifier: MIT
// A mass that is not positive counts as none, so a bore of negative density is lost.
#include "formulas/inertia.hpp"

#include <numbers>

namespace rigor {

MassProperties solid_cylinder(double density, double radius, double height)
{
    MassProperties result;
    const double r2 = radius * radius;
    result.mass = density * std::numbers::pi * r2 * height;
    if (!(result.mass > 0)) return MassProperties();
    const double across = result.mass / 12 * (3 * r2 + height * height);
    result.inertia = Vector3d(across, 0.5 * result.mass * r2, across).asDiagonal();
    return result;
}

} // namespace rigor
