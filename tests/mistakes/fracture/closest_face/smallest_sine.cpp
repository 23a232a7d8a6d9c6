// SPDX-License-Identifier: MIT
// The sines |n_f × n| are compared, which are all 1 where all faces are nearly across the crack.
#include "formulas/fracture.hpp"

#include <cmath>

namespace rigor {
namespace {

Vector3d area_of(const std::array<Vector3d, 4>& tetrahedron, int f)
{
    const Vector3d& a = tetrahedron[(f + 1) % 4];
    const Vector3d& b = tetrahedron[(f + 2) % 4];
    const Vector3d& c = tetrahedron[(f + 3) % 4];
    return (b - a).cross(c - a);
}

} // namespace

int closest_face(const std::array<Vector3d, 4>& tetrahedron, const Vector3d& normal)
{
    int best = 0;
    double smallest = 2;
    for (int f = 0; f < 4; ++f) {
        const Vector3d area = area_of(tetrahedron, f);
        const double size = area.norm();
        double sine = 1;
        if (size > 0) {
            const Vector3d n = area / size;
            sine = n.cross(normal).norm();
            if (std::abs(n.dot(normal)) < 1e-6) sine = std::sqrt(1 - std::pow(n.dot(normal), 2));
        }
        if (sine < smallest) {
            smallest = sine;
            best = f;
        }
    }
    return best;
}

} // namespace rigor
