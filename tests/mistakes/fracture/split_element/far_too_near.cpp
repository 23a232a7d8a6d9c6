// SPDX-License-Identifier: MIT
// The snap distance is five times too large: vertices far from the plane count as on it.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.snap_distance = 0.25;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
