// SPDX-License-Identifier: MIT
// Makes one element almost flat. The element needs so many substeps that a step would hardly end.
// Two points are earned: scenes that crack along faces do not call the formula.
// topic: fracture
// tasks: A7.8
// beside: split_element
// expect: 2 not_finite|timed_out|failed|crashed|not_implemented
#include "formulas/fracture.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    SplitMesh split = right_split_element(mesh, vertex, normal);
    const std::array<int, 4>& corners = split.mesh.tetrahedra.back();
    const auto base = static_cast<std::size_t>(corners[0]);
    const auto top = static_cast<std::size_t>(corners[3]);
    constexpr double height = 1e-5; // by the height before
    std::vector<Vector3d>& x = split.mesh.vertices;
    x[top] = x[base] + height * (x[top] - x[base]);
    split.origins[top] = {split.origins[base].first, split.origins[top].first, height};
    return split;
}

} // namespace rigor
