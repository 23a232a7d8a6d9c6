// SPDX-License-Identifier: MIT
// The plane contains the direction of the largest tension; it must be perpendicular to it.
#include "formulas/fracture.hpp"

namespace rigor {

std::optional<Vector3d> crack_plane(const Matrix3d& stress, double threshold)
{
    const PrincipalStress principal = principal_stress(stress);
    if (principal.stress <= 0 || principal.stress <= threshold) return {};
    return principal.direction.unitOrthogonal();
}

} // namespace rigor
