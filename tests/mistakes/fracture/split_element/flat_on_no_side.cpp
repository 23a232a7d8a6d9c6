// SPDX-License-Identifier: MIT
// A tetrahedron whose vertices all count as on the plane stays joined to both sides.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.side_on_plane = [](double) { return 0.0; };
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
