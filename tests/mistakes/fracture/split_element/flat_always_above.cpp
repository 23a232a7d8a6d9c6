// SPDX-License-Identifier: MIT
// A tetrahedron whose vertices all are on the plane counts as above it, wherever its center is.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.side_on_plane = [](double) { return 1.0; };
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
