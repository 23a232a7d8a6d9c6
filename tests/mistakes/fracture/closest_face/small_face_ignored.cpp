// SPDX-License-Identifier: MIT
// A face of less than 1e-12 m² counts as having no area.
#include "formulas/fracture.hpp"

#include <cmath>

namespace rigor {

int closest_face(const std::array<Vector3d, 4>& x, const Vector3d& normal)
{
    int closest = 0;
    double best = 0;
    for (int f = 0; f < 4; ++f) {
        const Vector3d &a = x[(f + 1) % 4], &b = x[(f + 2) % 4], &c = x[(f + 3) % 4];
        const Vector3d n_f = (b - a).cross(c - a);
        if (n_f.norm() < 1e-12) continue;
        const double alignment = std::abs(n_f.normalized().dot(normal));
        if (alignment > best) closest = f, best = alignment;
    }
    return closest;
}

} // namespace rigor
