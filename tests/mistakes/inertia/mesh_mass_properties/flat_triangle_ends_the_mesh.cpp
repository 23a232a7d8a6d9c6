// SPDX-License-Identifier: MIT
// The sum ends at the first triangle that has a vertex twice.
#include "mistakes/inertia/mesh_solid.hpp"

#include <algorithm>

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    TriangleMesh read = mesh;
    const auto end =
        std::find_if(read.triangles.begin(), read.triangles.end(), [](const std::array<int, 3>& t) {
            return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
        });
    read.triangles.erase(end, read.triangles.end());
    return read.triangles.empty() ? MassProperties() : solid_in_mesh(read, density);
}

} // namespace rigor
