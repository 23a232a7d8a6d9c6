// SPDX-License-Identifier: MIT
// Each part is cut by every crack: what is left without a corner is nobody's.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.clips_all = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
