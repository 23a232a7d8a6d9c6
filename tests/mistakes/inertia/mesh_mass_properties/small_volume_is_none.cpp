// SPDX-License-Identifier: MIT
// A volume below 1e-15 m³ counts as none, whatever the size of the mesh.
#include "mistakes/inertia/mesh_solid.hpp"

#include <cmath>

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    const MassProperties solid = solid_in_mesh(mesh, density);
    return std::abs(solid.mass) < 1e-15 * std::abs(density) ? MassProperties() : solid;
}

} // namespace rigor
