// SPDX-License-Identifier: MIT
// A volume below 1e-15 m³ counts as none, whatever the size of the mesh.
#include "formulas/inertia.hpp"

#include <cmath>

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    double V = 0;
    Vector3d Vx = Vector3d::Zero();
    Matrix3d Vxx = Matrix3d::Zero();
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vector3d a = mesh.vertices[i], b = mesh.vertices[j], c = mesh.vertices[k];
        const Vector3d s = a + b + c;
        const double det = a.dot(b.cross(c));
        V += det / 6;
        Vx += det / 24 * s;
        Vxx += det / 120 *
               (s * s.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    }
    if (std::abs(V) < 1e-15 || density == 0) return {};
    const Vector3d X = Vx / V;
    const Matrix3d C = Vxx - V * X * X.transpose();
    return {density * V, X, density * (C.trace() * Matrix3d::Identity() - C)};
}

} // namespace rigor
