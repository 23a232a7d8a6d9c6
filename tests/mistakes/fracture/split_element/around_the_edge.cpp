// SPDX-License-Identifier: MIT
// All tetrahedra of a cut edge must be halved, also those that no chain of faces reaches.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.halves_only_fan = true;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
