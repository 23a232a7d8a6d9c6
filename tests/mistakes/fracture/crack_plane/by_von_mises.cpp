// SPDX-License-Identifier: MIT
// The von Mises stress decides; that is the yield criterion of metals, not a criterion of fracture.
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
