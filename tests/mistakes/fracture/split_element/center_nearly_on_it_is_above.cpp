// SPDX-License-Identifier: MIT
// A center that is below the plane by no more than rounding counts as above it, as if on it.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.side_on_plane = [](double height) { return height >= -1e-15 ? 1.0 : -1.0; };
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
