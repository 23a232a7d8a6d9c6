// SPDX-License-Identifier: MIT
// How near a vertex may be depends on the edges of its own tetrahedra alone.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.by_own_edges = true;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
