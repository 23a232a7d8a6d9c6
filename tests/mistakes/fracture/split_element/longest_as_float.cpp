// SPDX-License-Identifier: MIT
// The longest edge is a float, so that vertices at nearly 0.05 of it are on the wrong side.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.float_longest = true;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
