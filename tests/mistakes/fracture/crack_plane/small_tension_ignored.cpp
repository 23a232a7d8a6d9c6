// SPDX-License-Identifier: MIT
// A tension below 1e-6 of the size of the stress opens no crack.
#include "formulas/fracture.hpp"

namespace rigor {

std::optional<Vector3d> crack_plane(const Matrix3d& stress, double threshold)
{
    const PrincipalStress principal = principal_stress(stress);
    if (principal.stress <= 1e-6 * stress.norm() || principal.stress <= threshold) return {};
    return principal.direction;
}

} // namespace rigor
