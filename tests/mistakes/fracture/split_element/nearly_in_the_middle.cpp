// SPDX-License-Identifier: MIT
// A new vertex that is nearly in the middle of its edge is moved there, off the plane.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.nearly_the_middle = 1e-6;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
