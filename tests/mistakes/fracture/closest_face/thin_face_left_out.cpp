// SPDX-License-Identifier: MIT
// A face whose area is tiny for its longest edge is left out, as if it had none.
#include "formulas/fracture.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

int closest_face(const std::array<Vector3d, 4>& x, const Vector3d& n)
{
    int closest = 0;
    double largest = 0;
    for (int f = 0; f < 4; ++f) {
        const Vector3d &a = x[(f + 1) % 4], &b = x[(f + 2) % 4], &c = x[(f + 3) % 4];
        const Vector3d area = (b - a).cross(c - a);
        const double longest =
            std::max({(b - a).stableNorm(), (c - b).stableNorm(), (a - c).stableNorm()});
        const double size = area.stableNorm();
        if (size <= 1e-12 * longest * longest) continue;
        const double value = std::abs(area.dot(n)) / size;
        if (value > largest) {
            largest = value;
            closest = f;
        }
    }
    return closest;
}

} // namespace rigor
