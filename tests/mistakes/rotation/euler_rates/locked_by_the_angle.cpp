// SPDX-License-Identifier: MIT
// Gimbal lock is found by the angle, whose remainder is wrong after many turns.
#include "formulas/rotation.hpp"

#include <cmath>
#include <numbers>

namespace rigor {

std::optional<Vector3d> euler_rates(const Vector3d& angles, const Vector3d& omega)
{
    const double pi = std::numbers::pi;
    if (std::abs(std::abs(std::remainder(angles.y(), pi)) - pi / 2) < 1e-12) return std::nullopt;
    const double s = std::sin(angles.z()), c = std::cos(angles.z());
    const double roll = (c * omega.x() + s * omega.y()) / std::cos(angles.y());
    return Vector3d(roll, c * omega.y() - s * omega.x(), omega.z() + std::sin(angles.y()) * roll);
}

} // namespace rigor
