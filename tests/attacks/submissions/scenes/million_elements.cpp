// SPDX-License-Identifier: MIT
// One answer has a million copies of an element, so that a single step of the engine takes minutes.
// Two points are earned: scenes that crack along faces do not call the formula.
// topic: fracture
// tasks: A7.8
// beside: split_element
// expect: 2 timed_out|failed|crashed|not_implemented
#include "formulas/fracture.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    SplitMesh split = right_split_element(mesh, vertex, normal);
    constexpr std::size_t copies = 1'000'000;
    split.mesh.tetrahedra.resize(copies, split.mesh.tetrahedra.back());
    split.parents.resize(copies, split.parents.back());
    return split;
}

} // namespace rigor
