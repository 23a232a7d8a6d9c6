// SPDX-License-Identifier: MIT
// The first face that is nearly parallel to the crack is taken, and not the nearest.
#include "formulas/fracture.hpp"

#include <cmath>

namespace rigor {

int closest_face(const std::array<Vector3d, 4>& tetrahedron, const Vector3d& normal)
{
    const std::array<Vector3d, 4>& x = tetrahedron;
    int closest = 0;
    double best = 0;
    for (int f = 0; f < 4; ++f) {
        const Vector3d &a = x[(f + 1) % 4], &b = x[(f + 2) % 4], &c = x[(f + 3) % 4];
        const double alignment = std::abs((b - a).cross(c - a).normalized().dot(normal));
        if (alignment > 1 - 1e-9) return f;
        if (alignment > best) {
            closest = f;
            best = alignment;
        }
    }
    return closest;
}

} // namespace rigor
