// SPDX-License-Identifier: MIT
// A part without matter is divided by no further crack, though cracks separate its corners.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.empty_stays = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
