// SPDX-License-Identifier: MIT
// A vertex that no tetrahedron uses must stay in the mesh.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.drops_unused = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
