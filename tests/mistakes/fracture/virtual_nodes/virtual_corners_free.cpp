// SPDX-License-Identifier: MIT
// Only the real corners of a shared face are connected; its virtual corners stay separate.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.joins_only_corners = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
