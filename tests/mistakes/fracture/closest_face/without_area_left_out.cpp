// SPDX-License-Identifier: MIT
// A face without area is left out; it counts as 0 and may be the first of equal ones.
#include "formulas/fracture.hpp"

#include <cmath>

namespace rigor {

int closest_face(const std::array<Vector3d, 4>& tetrahedron, const Vector3d& normal)
{
    const std::array<Vector3d, 4>& x = tetrahedron;
    int closest = 0;
    double best = -1;
    for (int f = 0; f < 4; ++f) {
        const Vector3d &a = x[(f + 1) % 4], &b = x[(f + 2) % 4], &c = x[(f + 3) % 4];
        const Vector3d area = (b - a).cross(c - a);
        if (area.isZero(0)) continue;
        const double alignment = std::abs(area.normalized().dot(normal));
        if (alignment > best) {
            closest = f;
            best = alignment;
        }
    }
    return closest;
}

} // namespace rigor
