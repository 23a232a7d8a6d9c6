// SPDX-License-Identifier: MIT
// A corner on the plane must count as on the side of the normal, not on the other side.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.on_plane_is_below = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
