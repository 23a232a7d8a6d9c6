// SPDX-License-Identifier: MIT
// Copies of neighbors are connected wherever they share a face, even across the crack.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.joins_always = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
