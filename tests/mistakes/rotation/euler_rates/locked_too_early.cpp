// SPDX-License-Identifier: MIT
// Gimbal lock begins at |cos θ| < 1e-8 instead of 1e-12.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

std::optional<Vector3d> euler_rates(const Vector3d& angles, const Vector3d& omega)
{
    const double c = std::cos(angles.y());
    if (std::abs(c) < 1e-8) return std::nullopt;
    const Vector3d w = Eigen::AngleAxisd(-angles.z(), Vector3d::UnitZ()) * omega;
    const double roll = w.x() / c;
    return Vector3d(roll, w.y(), w.z() + roll * std::sin(angles.y()));
}

} // namespace rigor
