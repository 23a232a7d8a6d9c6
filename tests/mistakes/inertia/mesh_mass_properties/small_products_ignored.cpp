// SPDX-License-Identifier: MIT
// Products of inertia below 1e-11 of the trace become 0.
#include "mistakes/inertia/mesh_solid.hpp"

#include <cmath>

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    MassProperties result = solid_in_mesh(mesh, density);
    Matrix3d& I = result.inertia;
    for (int i = 0; i < 9; ++i)
        if (i % 4 != 0 && std::abs(I(i)) < 1e-11 * I.trace()) I(i) = 0;
    return result;
}

} // namespace rigor
