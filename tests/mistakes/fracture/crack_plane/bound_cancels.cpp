// SPDX-License-Identifier: MIT
// The bound that calls a stress safe loses digits if the principal stresses are nearly equal.
#include "formulas/fracture.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

std::optional<Vector3d> crack_plane(const Matrix3d& stress, double threshold)
{
    const double strength = std::max(threshold, 0.0);
    const double trace = stress.trace();
    const double square = 1.5 * (stress.squaredNorm() - trace * trace / 3);
    const double bound = trace / 3 + 2.0 / 3 * std::sqrt(std::max(0.0, square));
    if (bound < strength * (1 - 1e-14)) return std::nullopt; // safe, without eigenvalues
    const PrincipalStress first = principal_stress(stress);
    if (first.stress > strength) return first.direction;
    return std::nullopt;
}

} // namespace rigor
