// SPDX-License-Identifier: MIT
// The center is a mean of places, not of heights; far from the origin its digits are lost.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.center_in_space = true;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
