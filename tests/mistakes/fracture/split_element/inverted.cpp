// SPDX-License-Identifier: MIT
// One half of each split tetrahedron has two corners swapped and is inverted.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.swaps_corners = true;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
