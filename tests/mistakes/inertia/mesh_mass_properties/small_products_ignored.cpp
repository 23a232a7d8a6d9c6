// SPDX-License-Identifier: MIT
// Products of inertia below 1e-11 of the trace become 0.
#include "formulas/inertia.hpp"

#include <cmath>

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    double V = 0;
    Vector3d Vx = Vector3d::Zero();
    Matrix3d Vxx = Matrix3d::Zero();
    for (const auto& t : mesh.triangles) {
        const Vector3d o = mesh.vertices[mesh.triangles[0][0]];
        const Vector3d x1 = mesh.vertices[t[0]] - o, x2 = mesh.vertices[t[1]] - o,
                       x3 = mesh.vertices[t[2]] - o;
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
    Matrix3d I = C.trace() * Matrix3d::Identity() - C;
    for (int i = 0; i < 9; ++i)
        if (i % 4 != 0 && std::abs(I(i)) < 1e-11 * I.trace()) I(i) = 0;
    return {density * V, mesh.vertices[mesh.triangles[0][0]] + X, I};
}

} // namespace rigor
