// SPDX-License-Identifier: MIT
#include "deformable/fracture/checked_answers.hpp"

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace rigor {

namespace {

// The most parts into which one tetrahedron may come. Along faces it stays whole. A plane with two
// corners on each side cuts it into two wedges of three tetrahedra, and any other plane into fewer.
// Its virtual nodes make a copy for each group of its four corners.
constexpr int most_whole = 1, most_pieces = 6, most_copies = 4;

// A number with the digits that a message needs.
std::string shortly(double number)
{
    std::ostringstream text;
    text << std::setprecision(4) << number;
    return text.str();
}

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
    // A share or a fraction, which rounding may take a little beyond 0 or 1.
    void is_share(const char* what, double share) const
    {
        constexpr double rounding = 1e-9;
        if (!(share >= -rounding && share <= 1 + rounding))
            throw std::out_of_range(formula_ + " returned " + what + " of " + shortly(share) +
                                    " where 0 to 1 was expected");
    }
    // Each tetrahedron is still there, in at most `most` parts.
    // @param parents  for each part, the tetrahedron that it is a part of; valid indices
    void keeps_all(const std::vector<int>& parents, std::size_t tetrahedra, int most) const
    {
        std::vector<int> parts(tetrahedra, 0);
        for (const int parent : parents)
            ++parts[parent];
        for (std::size_t t = 0; t < tetrahedra; ++t)
            if (parts[t] < 1 || parts[t] > most)
                throw std::out_of_range(
                    formula_ + " returned " + std::to_string(parts[t]) + " parts of tetrahedron " +
                    std::to_string(t) + " where " +
                    (most == 1 ? "1 was" : "1 to " + std::to_string(most) + " were") + " expected");
    }
    // A vertex is one of the mesh before, or a corner of a tetrahedron.
    void has_no_ballast(const TetrahedralMesh& mesh, const TetrahedralMesh& before) const
    {
        const std::size_t most = before.vertices.size() + 4 * mesh.tetrahedra.size();
        if (mesh.vertices.size() > most)
            throw std::out_of_range(formula_ + " returned " + std::to_string(mesh.vertices.size()) +
                                    " vertices where at most " + std::to_string(most) +
                                    " were expected");
    }
    void is_mesh(const TetrahedralMesh& mesh) const
    {
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
            if (!mesh.vertices[v].allFinite())
                throw std::out_of_range(formula_ + " returned a place that is not finite, of " +
                                        "vertex " + std::to_string(v));
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

std::optional<Vector3d> checked_normal(std::optional<Vector3d> normal)
{
    if (normal && !normal->allFinite())
        throw std::out_of_range("crack_plane returned a normal that is not finite");
    return normal;
}

namespace {

void check_split(const Answer& answer, const SplitMesh& split, const TetrahedralMesh& before,
                 int most_parts)
{
    answer.has_no_ballast(split.mesh, before);
    answer.is_mesh(split.mesh);
    answer.has("origins", split.origins.size(), split.mesh.vertices.size());
    answer.has("parents", split.parents.size(), split.mesh.tetrahedra.size());
    answer.all_point_into("a parent", split.parents, before.tetrahedra.size());
    for (const VertexOrigin& origin : split.origins) {
        for (const int vertex : {origin.first, origin.second})
            answer.points_into("an origin", vertex, before.vertices.size());
        answer.is_share("an origin with a fraction", origin.fraction);
    }
    answer.keeps_all(split.parents, before.tetrahedra.size(), most_parts);
}

} // namespace

SplitMesh checked_split_element(SplitMesh split, const TetrahedralMesh& before)
{
    check_split(Answer("split_element"), split, before, most_pieces);
    return split;
}

SplitMesh checked_split_along_faces(SplitMesh split, const TetrahedralMesh& before)
{
    const Answer answer("split_along_faces");
    answer.has("tetrahedra", split.mesh.tetrahedra.size(), before.tetrahedra.size());
    check_split(answer, split, before, most_whole);
    return split;
}

EmbeddedMesh checked_embedding(EmbeddedMesh embedded, const TetrahedralMesh& before)
{
    const Answer answer("virtual_nodes");
    const std::size_t elements = embedded.mesh.tetrahedra.size();
    answer.has_no_ballast(embedded.mesh, before);
    answer.is_mesh(embedded.mesh);
    answer.has("vertex_parents", embedded.vertex_parents.size(), embedded.mesh.vertices.size());
    answer.has("parents", embedded.parents.size(), elements);
    answer.has("corners", embedded.real.size(), elements);
    answer.has("fractions", embedded.fractions.size(), elements);
    answer.all_point_into("a parent", embedded.parents, before.tetrahedra.size());
    answer.all_point_into("a parent", embedded.vertex_parents, before.vertices.size());
    answer.keeps_all(embedded.parents, before.tetrahedra.size(), most_copies);
    for (const double fraction : embedded.fractions)
        answer.is_share("a fraction", fraction);
    for (const std::array<int, 4>& real : embedded.real) {
        for (const int corner : real)
            if (corner != 0 && corner != 1)
                throw std::out_of_range("virtual_nodes returned a corner that is " +
                                        std::to_string(corner) +
                                        " where 1, real, or 0, virtual, was expected");
        if (std::find(real.begin(), real.end(), 1) == real.end())
            throw std::out_of_range("virtual_nodes returned an element without a real corner");
    }
    return embedded;
}

} // namespace rigor
