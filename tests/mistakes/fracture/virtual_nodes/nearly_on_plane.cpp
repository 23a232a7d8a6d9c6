// SPDX-License-Identifier: MIT
// A corner whose height is tiny beside the largest one counts as lying on the plane, so it may be
// on the wrong side.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.nearly_on_plane = 1e-13;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
