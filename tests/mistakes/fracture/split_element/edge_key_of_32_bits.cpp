// SPDX-License-Identifier: MIT
// Cut edges are named by keys of 32 bits, so two edges of a long list of vertices may be one.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.merges_edges = true;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
