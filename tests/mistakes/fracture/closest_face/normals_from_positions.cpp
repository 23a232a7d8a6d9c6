// SPDX-License-Identifier: MIT
// Normals come from products of positions, not of edges, and lose digits far from the origin.
#include "formulas/fracture.hpp"

namespace rigor {

int closest_face(const std::array<Vector3d, 4>& tetrahedron, const Vector3d& normal)
{
    int best = 0;
    double largest = -1;
    for (int f = 0; f < 4; ++f) {
        const Vector3d& a = tetrahedron[(f + 1) % 4];
        const Vector3d& b = tetrahedron[(f + 2) % 4];
        const Vector3d& c = tetrahedron[(f + 3) % 4];
        const Vector3d area = a.cross(b) + b.cross(c) + c.cross(a);
        const double size = area.norm();
        const double value = size > 0 ? std::abs(area.dot(normal)) / size : 0;
        if (value > largest) {
            largest = value;
            best = f;
        }
    }
    return best;
}

} // namespace rigor
