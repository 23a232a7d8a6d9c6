// SPDX-License-Identifier: MIT
// The axis of the cylinder is y; here it is z.
#include "formulas/inertia.hpp"

#include <numbers>

namespace rigor {

MassProperties solid_cylinder(double density, double radius, double height)
{
    const double M = density * std::numbers::pi * radius * radius * height;
    const double axial = M / 2 * radius * radius;
    const double across = M / 12 * (3 * radius * radius + height * height);
    return {M, Vector3d::Zero(), Vector3d(across, across, axial).asDiagonal()};
}

} // namespace rigor
