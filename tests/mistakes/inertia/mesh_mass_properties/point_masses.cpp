// SPDX-License-Identifier: MIT
// Each tetrahedron is treated as a point mass at its centroid, without its own extent.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    double V = 0;
    Vector3d Vx = Vector3d::Zero();
    Matrix3d Vxx = Matrix3d::Zero();
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vector3d a = mesh.vertices[i], b = mesh.vertices[j], c = mesh.vertices[k];
        const Vector3d centroid = (a + b + c) / 4;
        const double volume = a.dot(b.cross(c)) / 6;
        V += volume;
        Vx += volume * centroid;
        Vxx += volume * centroid * centroid.transpose();
    }
    if (V == 0) return {};
    const Vector3d X = Vx / V;
    const Matrix3d C = density * (Vxx - V * X * X.transpose());
    return {density * V, X, C.trace() * Matrix3d::Identity() - C};
}

} // namespace rigor
