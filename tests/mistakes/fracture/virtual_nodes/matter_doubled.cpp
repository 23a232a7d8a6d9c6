// SPDX-License-Identifier: MIT
// Each copy gets the whole volume of its parent instead of its share.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.whole_shares = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
