// SPDX-License-Identifier: MIT
// Every tetrahedron at the vertex is separated from all others, not only across the plane.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.opens_rim = true;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
