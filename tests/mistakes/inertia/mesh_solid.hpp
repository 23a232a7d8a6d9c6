// SPDX-License-Identifier: MIT
// The right mass properties of a solid within a triangle mesh (A2.13), for mistakes that compute
// them rightly and then or before do something wrong.
#pragma once

#include "formulas/inertia.hpp"

namespace rigor {

inline MassProperties solid_in_mesh(const TriangleMesh& mesh, double density)
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
    return {density * V, mesh.vertices[mesh.triangles[0][0]] + X,
            C.trace() * Matrix3d::Identity() - C};
}

} // namespace rigor
