// SPDX-License-Identifier: MIT
// A tetrahedron that an earlier crack has separated keeps its edge, which is at the same place.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.halves_across_cracks = true;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
