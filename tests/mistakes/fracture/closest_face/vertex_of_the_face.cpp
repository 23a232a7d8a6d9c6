// SPDX-License-Identifier: MIT
// The index of a vertex on the face is returned instead of that of the opposite vertex.
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
        const Vector3d n_f = (b - a).cross(c - a).normalized();
        const double alignment = std::abs(n_f.dot(normal));
        if (alignment > best) {
            closest = (f + 1) % 4;
            best = alignment;
        }
    }
    return closest;
}

} // namespace rigor
