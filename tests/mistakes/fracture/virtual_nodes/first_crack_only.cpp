// SPDX-License-Identifier: MIT
// Only the first crack of a tetrahedron is used; the later ones are ignored.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.first_crack_only = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
