// SPDX-License-Identifier: MIT
// The elements are split, but the crack is not opened.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.opens = false;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
