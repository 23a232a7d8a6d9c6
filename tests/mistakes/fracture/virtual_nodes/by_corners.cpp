// SPDX-License-Identifier: MIT
// A share of a quarter for each real corner.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.corner_shares = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
