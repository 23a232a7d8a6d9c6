// SPDX-License-Identifier: MIT
// Components of the normal below 1e-9 are taken for rounding errors and left out.
#include "mistakes/fracture/element_rules.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    const Vector3d cleaned = (normal.array().abs() < 1e-9).select(Vector3d::Zero(), normal);
    return cutting::split_by(cutting::ElementRules(), mesh, vertex, cleaned);
}

} // namespace rigor
