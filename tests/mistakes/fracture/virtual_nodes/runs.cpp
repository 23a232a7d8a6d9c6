// SPDX-License-Identifier: MIT
// The cracks of a tetrahedron are read as one run of the list; a later run replaces an earlier one.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    std::vector<ElementCrack> kept;
    for (std::size_t i = 0; i < cracks.size(); ++i) {
        const int t = cracks[i].tetrahedron;
        if (i > 0 && cracks[i - 1].tetrahedron != t)
            std::erase_if(kept,
                          [t](const ElementCrack& earlier) { return earlier.tetrahedron == t; });
        kept.push_back(cracks[i]);
    }
    cutting::CopyRules rules;
    return cutting::copies_by(rules, mesh, kept);
}

} // namespace rigor
