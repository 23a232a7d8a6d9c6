// SPDX-License-Identifier: MIT
// A center a micrometre below the plane is below it: only a center exactly on it counts as above.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.side_on_plane = [](double height) { return height >= -1e-6 ? 1.0 : -1.0; };
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
