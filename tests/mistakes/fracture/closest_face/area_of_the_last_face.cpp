// SPDX-License-Identifier: MIT
// The area of the last face is the sum of the others, so it has few digits if this face is small.
#include "formulas/fracture.hpp"

#include <cmath>

namespace rigor {

int closest_face(const std::array<Vector3d, 4>& x, const Vector3d& normal)
{
    const Vector3d a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
    Vector3d area[4] = {(b - a).cross(c - a), c.cross(b), a.cross(c), {}};
    area[3] = -(area[0] + area[1] + area[2]);
    int closest = 0;
    double best = 0;
    for (int f = 0; f < 4; ++f) {
        if (area[f].isZero(0)) continue;
        const double alignment = std::abs(area[f].stableNormalized().dot(normal));
        if (alignment > best) closest = f, best = alignment;
    }
    return closest;
}

} // namespace rigor
