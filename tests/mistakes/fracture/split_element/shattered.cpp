// SPDX-License-Identifier: MIT
// The tetrahedra of the vertex come apart from all others.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    cutting::ElementRules rules;
    rules.opens_rim = true;
    return cutting::split_by(rules, mesh, vertex, normal);
}

} // namespace rigor
