// SPDX-License-Identifier: MIT
// A surface with an odd number of triangles counts as open.
#include "mistakes/inertia/mesh_solid.hpp"

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    if (mesh.triangles.size() % 2 == 1) return {};
    return solid_in_mesh(mesh, density);
}

} // namespace rigor
