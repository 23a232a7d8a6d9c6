// SPDX-License-Identifier: MIT
// The share of the volume is estimated as a quarter for each real corner; it must be measured.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.corner_shares = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
