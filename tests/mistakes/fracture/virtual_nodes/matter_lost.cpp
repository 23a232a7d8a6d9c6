// SPDX-License-Identifier: MIT
// Each part is clipped by every crack, so a region without a real corner belongs to no part.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.clips_all = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
