// SPDX-License-Identifier: MIT
// A tetrahedron whose center is exactly on the plane is above it, not below.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.side_on_plane = [](double height) { return height > 0 ? 1.0 : -1.0; };
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
