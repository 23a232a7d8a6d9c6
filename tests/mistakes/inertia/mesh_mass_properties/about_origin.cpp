// SPDX-License-Identifier: MIT
// The integral over the tetrahedra is about the origin and was not moved to the center of mass.
#include "mistakes/inertia/mesh_solid.hpp"

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    MassProperties solid = solid_in_mesh(mesh, density);
    const Vector3d& X = solid.center_of_mass;
    solid.inertia += solid.mass * (X.squaredNorm() * Matrix3d::Identity() - X * X.transpose());
    return solid;
}

} // namespace rigor
