// SPDX-License-Identifier: MIT
// Neighbors of the split tetrahedra are not split, which leaves vertices inside their edges.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.halves_neighbours = false;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
