// SPDX-License-Identifier: MIT
// The sign is wrong: the products of inertia are minus the integrals of x y.
#include "mistakes/inertia/mesh_solid.hpp"

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    MassProperties solid = solid_in_mesh(mesh, density);
    const Vector3d moments = solid.inertia.diagonal();
    solid.inertia = -solid.inertia;
    solid.inertia.diagonal() = moments;
    return solid;
}

} // namespace rigor
