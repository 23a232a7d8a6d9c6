// SPDX-License-Identifier: MIT
// The neighbours keep their edges whole, with a vertex in the middle of them.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.halves_neighbours = false;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
