// SPDX-License-Identifier: MIT
#include "deformable/fracture/checked_answers.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace rigor {

namespace {

// Checks what a formula returned. The messages of errors begin with the name of the formula.
class Answer {
public:
    explicit Answer(const char* formula) : formula_(formula) {}

    void has(const char* what, std::size_t found, std::size_t expected) const
    {
        if (found != expected)
            throw std::out_of_range(formula_ + " returned " + std::to_string(found) + " " + what +
                                    " where " + std::to_string(expected) + " were expected");
    }
    void points_into(const char* what, int index, std::size_t size) const
    {
        if (index < 0 || static_cast<std::size_t>(index) >= size)
            throw std::out_of_range(formula_ + " returned the index " + std::to_string(index) +
                                    " of " + what + ", of which there are " + std::to_string(size));
    }
    void all_point_into(const char* what, const std::vector<int>& indices, std::size_t size) const
    {
        for (const int index : indices)
            points_into(what, index, size);
    }
    void is_mesh(const TetrahedralMesh& mesh) const
    {
        for (const auto& corners : mesh.tetrahedra)
            for (const int vertex : corners)
                points_into("a vertex", vertex, mesh.vertices.size());
    }

private:
    std::string formula_;
};

} // namespace

std::vector<Matrix3d> checked_stresses(std::vector<Matrix3d> smooth, std::size_t elements)
{
    Answer("smooth_stress").has("stresses", smooth.size(), elements);
    return smooth;
}

int checked_face(int face)
{
    Answer("closest_face").points_into("a face", face, 4);
    return face;
}

SplitMesh checked_split(SplitMesh split, const TetrahedralMesh& before, const char* formula)
{
    const Answer answer(formula);
    answer.is_mesh(split.mesh);
    answer.has("origins", split.origins.size(), split.mesh.vertices.size());
    answer.has("parents", split.parents.size(), split.mesh.tetrahedra.size());
    answer.all_point_into("a parent", split.parents, before.tetrahedra.size());
    for (const VertexOrigin& origin : split.origins)
        for (const int vertex : {origin.first, origin.second})
            answer.points_into("an origin", vertex, before.vertices.size());
    return split;
}

SplitMesh checked_split_along_faces(SplitMesh split, const TetrahedralMesh& before)
{
    constexpr const char* formula = "split_along_faces";
    Answer(formula).has("tetrahedra", split.mesh.tetrahedra.size(), before.tetrahedra.size());
    return checked_split(std::move(split), before, formula);
}

EmbeddedMesh checked_embedding(EmbeddedMesh embedded, const TetrahedralMesh& before)
{
    const Answer answer("virtual_nodes");
    const std::size_t elements = embedded.mesh.tetrahedra.size();
    answer.is_mesh(embedded.mesh);
    answer.has("vertex_parents", embedded.vertex_parents.size(), embedded.mesh.vertices.size());
    answer.has("parents", embedded.parents.size(), elements);
    answer.has("corners", embedded.real.size(), elements);
    answer.has("fractions", embedded.fractions.size(), elements);
    answer.all_point_into("a parent", embedded.parents, before.tetrahedra.size());
    answer.all_point_into("a parent", embedded.vertex_parents, before.vertices.size());
    for (const std::array<int, 4>& real : embedded.real)
        if (std::find(real.begin(), real.end(), 1) == real.end())
            throw std::out_of_range("virtual_nodes returned an element without a real corner");
    return embedded;
}

} // namespace rigor
