// SPDX-License-Identifier: MIT
// Where cos θ is negative, the body counts as locked, since |cos θ| is not taken.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

std::optional<Vector3d> euler_rates(const Vector3d& angles, const Vector3d& omega)
{
    const double c = std::cos(angles.y());
    if (c < 1e-12) return std::nullopt;
    const Vector3d w = Eigen::AngleAxisd(-angles.z(), Vector3d::UnitZ()) * omega;
    const double roll = w.x() / c;
    return Vector3d(roll, w.y(), w.z() + roll * std::sin(angles.y()));
}

} // namespace rigor
