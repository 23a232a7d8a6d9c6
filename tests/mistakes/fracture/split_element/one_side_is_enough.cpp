// SPDX-License-Identifier: MIT
// The mesh must not split if no vertex is above the plane; here a flat tetrahedron splits off.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.asks_for_both_sides = false;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
