// SPDX-License-Identifier: MIT
// If faces are nearly equally near, the first is taken, and not the nearer one.
#include "formulas/fracture.hpp"

#include <cmath>

namespace rigor {

int closest_face(const std::array<Vector3d, 4>& tetrahedron, const Vector3d& normal)
{
    int best = 0;
    double most = 0;
    for (int f = 0; f < 4; ++f) {
        const Vector3d &a = tetrahedron[(f + 1) % 4], &b = tetrahedron[(f + 2) % 4],
                       &c = tetrahedron[(f + 3) % 4];
        const Vector3d area = (b - a).cross(c - a);
        const double near = area.isZero(0) ? 0 : std::abs(area.normalized().dot(normal));
        if (near > most + 1e-9) {
            most = near;
            best = f;
        }
    }
    return best;
}

} // namespace rigor
