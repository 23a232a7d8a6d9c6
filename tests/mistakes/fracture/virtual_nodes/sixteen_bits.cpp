// SPDX-License-Identifier: MIT
// Numbers of copies are kept in 16 bits, so that copies beyond 65535 are joined to wrong ones.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    rules.sixteen_bits = true;
    return cutting::copies_by(rules, mesh, cracks);
}

} // namespace rigor
