// SPDX-License-Identifier: MIT
// Edges are split at their midpoint instead of where the plane meets them.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.halves_in_the_middle = true;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
