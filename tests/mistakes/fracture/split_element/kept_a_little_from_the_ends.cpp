// SPDX-License-Identifier: MIT
// A new vertex is kept just a little farther from the ends of its edge than a vertex that does not
// count as lying on the plane has to be.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.nearest_to_an_end = 0.052;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
