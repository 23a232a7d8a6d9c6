// SPDX-License-Identifier: MIT
// The snap distance is nearly zero, so that cuts close to a vertex leave slivers.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.snap_distance = 1e-12;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
