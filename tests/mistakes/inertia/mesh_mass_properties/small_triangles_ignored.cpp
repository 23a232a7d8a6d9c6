// SPDX-License-Identifier: MIT
// Triangles with less than a millionth of the area of the largest are left out.
#include "formulas/inertia.hpp"

#include <algorithm>

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    const auto corner_of = [&](const std::array<int, 3>& t, int corner) -> const Vector3d& {
        return mesh.vertices[t[corner]];
    };
    const auto area = [&](const std::array<int, 3>& t) {
        return (corner_of(t, 1) - corner_of(t, 0)).cross(corner_of(t, 2) - corner_of(t, 0)).norm();
    };
    double largest = 0;
    for (const auto& t : mesh.triangles)
        largest = std::max(largest, area(t));
    MassProperties all;
    double V = 0;
    Vector3d Vx = Vector3d::Zero();
    Matrix3d Vxx = Matrix3d::Zero();
    for (const auto& t : mesh.triangles) {
        if (area(t) < 1e-6 * largest) continue;
        const Vector3d x1 = corner_of(t, 0), x2 = corner_of(t, 1), x3 = corner_of(t, 2);
        const double det = x1.dot(x2.cross(x3));
        const Vector3d s = x1 + x2 + x3;
        V += det / 6;
        Vx += det / 24 * s;
        Vxx +=
            det / 120 *
            (s * s.transpose() + x1 * x1.transpose() + x2 * x2.transpose() + x3 * x3.transpose());
    }
    if (V == 0 || density == 0) return {};
    const Vector3d X = Vx / V;
    const Matrix3d C = density * (Vxx - V * X * X.transpose());
    return {density * V, X, C.trace() * Matrix3d::Identity() - C};
}

} // namespace rigor
