// SPDX-License-Identifier: MIT
// A vertex at exactly 0.05 of the longest edge counts as lying on the plane.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.snaps_at_the_limit = true;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
