// SPDX-License-Identifier: MIT
// A mesh that is inside out gets a positive mass, but its inertia stays negative.
#include "mistakes/inertia/mesh_solid.hpp"

#include <cmath>

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    MassProperties solid = solid_in_mesh(mesh, density);
    solid.mass = std::copysign(solid.mass, density);
    return solid;
}

} // namespace rigor
