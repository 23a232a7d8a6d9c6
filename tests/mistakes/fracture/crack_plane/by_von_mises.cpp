// SPDX-License-Identifier: MIT
// The yield criterion decides, which is for metal that flows.
#include "formulas/fracture.hpp"

#include <cmath>

namespace rigor {

std::optional<Vector3d> crack_plane(const Matrix3d& stress, double threshold)
{
    const Matrix3d deviator = stress - stress.trace() / 3 * Matrix3d::Identity();
    const PrincipalStress principal = principal_stress(stress);
    if (principal.stress <= 0 || std::sqrt(1.5) * deviator.norm() <= threshold) return {};
    return principal.direction;
}

} // namespace rigor
