// SPDX-License-Identifier: MIT
// A piece with hardly any of the tetrahedron is not cut any more: one side gets all of it.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.sliver = 1e-11;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
