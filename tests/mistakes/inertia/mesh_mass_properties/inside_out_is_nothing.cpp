// SPDX-License-Identifier: MIT
// A mesh that is inside out has a negative mass; here it has none.
#include "mistakes/inertia/mesh_solid.hpp"

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    const MassProperties solid = solid_in_mesh(mesh, density);
    return solid.mass * density <= 0 ? MassProperties() : solid;
}

} // namespace rigor
