// SPDX-License-Identifier: MIT
// Copies of neighbours are joined wherever they share a face, also across the crack.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.joins_always = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
