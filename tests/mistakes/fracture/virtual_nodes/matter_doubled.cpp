// SPDX-License-Identifier: MIT
// Each copy has all of the matter of its parent.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.whole_shares = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
