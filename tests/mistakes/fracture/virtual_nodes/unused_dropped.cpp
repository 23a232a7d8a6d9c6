// SPDX-License-Identifier: MIT
// A vertex that no tetrahedron uses must stay in the mesh.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.drops_unused = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
