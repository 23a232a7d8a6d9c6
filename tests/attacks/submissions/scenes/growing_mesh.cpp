// SPDX-License-Identifier: MIT
// Each split adds twenty thousand copies of an element, so that the engine computes and records
// without end. Two points are earned: scenes that crack along faces do not call the formula.
// topic: fracture
// tasks: A7.8
// beside: split_element
// expect: 2 timed_out|failed|crashed|not_implemented
#include "formulas/fracture.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    SplitMesh split = right_split_element(mesh, vertex, normal);
    for (int i = 0; i < 20'000; ++i) {
        split.mesh.tetrahedra.push_back(split.mesh.tetrahedra.back());
        split.parents.push_back(split.parents.back());
    }
    return split;
}

} // namespace rigor
