// SPDX-License-Identifier: MIT
// A surface counts as open if the triangles along an edge do not name the same vertices.
#include "mistakes/inertia/mesh_solid.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace rigor {

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    std::map<std::pair<int, int>, int> sums; // +1 or -1 for each side of an edge, by direction
    for (const auto& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const int a = t[i], b = t[(i + 1) % 3];
            sums[std::minmax({a, b})] += a < b ? 1 : -1;
        }
    for (const auto& [edge, sum] : sums)
        if (sum != 0 && edge.first != edge.second) return {};
    return solid_in_mesh(mesh, density);
}

} // namespace rigor
