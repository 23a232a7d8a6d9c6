// SPDX-License-Identifier: MIT
// The snap distance of a vertex comes from the edges of its own tetrahedra, not of all.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.by_own_edges = true;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
