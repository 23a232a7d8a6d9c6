// SPDX-License-Identifier: MIT
// A new vertex is kept away from the ends of its edge, so it is not on the plane.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.nearest_to_an_end = 0.06;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
