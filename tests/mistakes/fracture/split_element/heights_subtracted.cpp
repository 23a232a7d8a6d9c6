// SPDX-License-Identifier: MIT
// Heights are n·x - n·x_v. Far from the origin their digits cancel.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.subtracts_heights = true;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
