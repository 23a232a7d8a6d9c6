// SPDX-License-Identifier: MIT
// The first face that is parallel to the crack up to 1e-12 is taken, although a later one may be
// nearer still.
#include "formulas/fracture.hpp"

#include <cmath>

namespace rigor {

int closest_face(const std::array<Vector3d, 4>& tetrahedron, const Vector3d& normal)
{
    const std::array<Vector3d, 4>& x = tetrahedron;
    int closest = 0;
    double largest = -1;
    for (int f = 0; f < 4; ++f) {
        const Vector3d &a = x[(f + 1) % 4], &b = x[(f + 2) % 4], &c = x[(f + 3) % 4];
        const Vector3d area = (b - a).cross(c - a);
        const double size = area.norm();
        const double value = size > 0 ? std::abs(area.dot(normal)) / size : 0;
        if (value > largest) {
            closest = f;
            largest = value;
        }
        if (largest > 1 - 1e-12) break; // none can be nearer
    }
    return closest;
}

} // namespace rigor
