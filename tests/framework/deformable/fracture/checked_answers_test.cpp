// SPDX-License-Identifier: MIT
// Wrong answers of the formulas of fracture are refused before the engine indexes with them.
#include "deformable/fracture/checked_answers.hpp"
#include "formulas/fracture.hpp"
#include "support/catch.hpp"

#include <functional>
#include <stdexcept>

namespace rigor {

namespace {

// Two tetrahedra that share a face.
TetrahedralMesh pair_of_tetrahedra()
{
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{0, 1, 2, 3}, {4, 2, 1, 3}}};
}

SplitMesh right_split()
{
    return split_along_faces(pair_of_tetrahedra(), {{0, 0}});
}

EmbeddedMesh right_embedding()
{
    return virtual_nodes(pair_of_tetrahedra(), {{0, {0.2, 0.2, 0.2}, Vector3d::UnitX()}});
}

constexpr int wrong_indices[] = {-1, 5, 100, 200000000, -2147483647};

} // namespace

TEST_CASE("checked answers: right answers pass unchanged")
{
    const SplitMesh split = checked_split_along_faces(right_split(), pair_of_tetrahedra());
    REQUIRE(split.parents == right_split().parents);
    REQUIRE(split.mesh.tetrahedra == right_split().mesh.tetrahedra);
    const EmbeddedMesh embedded = checked_embedding(right_embedding(), pair_of_tetrahedra());
    REQUIRE(embedded.parents == right_embedding().parents);
    REQUIRE(checked_stresses(std::vector<Matrix3d>(3), 3).size() == 3);
    REQUIRE(checked_face(0) == 0);
    REQUIRE(checked_face(3) == 3);
}

TEST_CASE("checked answers: a wrong number of stresses, and no face, are refused")
{
    REQUIRE_THROWS_WITH(checked_stresses(std::vector<Matrix3d>(2), 3),
                        "smooth_stress returned 2 stresses where 3 were expected");
    REQUIRE_THROWS_AS(checked_stresses({}, 1), std::out_of_range);
    REQUIRE_THROWS_WITH(checked_face(4),
                        "closest_face returned the index 4 of a face, of which there are 4");
    REQUIRE_THROWS_AS(checked_face(-1), std::out_of_range);
}

TEST_CASE("checked answers: each wrong index or length of a split is refused")
{
    for (const int wrong : wrong_indices) {
        const std::function<void(SplitMesh&)> slips[] = {
            [&](SplitMesh& s) { s.mesh.tetrahedra[1][2] = wrong < 5 ? wrong : wrong + 100; },
            [&](SplitMesh& s) { s.origins.back().first = wrong; },
            [&](SplitMesh& s) { s.origins[0].second = wrong; },
            [&](SplitMesh& s) { s.parents[1] = wrong; },
            [&](SplitMesh& s) { s.origins.pop_back(); },
            [&](SplitMesh& s) { s.parents.clear(); },
            [&](SplitMesh& s) { s.mesh.vertices.resize(1); },
            [&](SplitMesh& s) { s.mesh.tetrahedra.pop_back(); },
        };
        for (const auto& slip : slips) {
            CAPTURE(wrong, &slip - slips);
            SplitMesh split = right_split();
            slip(split);
            REQUIRE_THROWS_AS(checked_split_along_faces(split, pair_of_tetrahedra()),
                              std::out_of_range);
        }
    }
    REQUIRE_THROWS_AS(checked_split_along_faces({}, pair_of_tetrahedra()), std::out_of_range);
}

TEST_CASE("checked answers: each wrong index or length of an embedding is refused")
{
    for (const int wrong : wrong_indices) {
        const std::function<void(EmbeddedMesh&)> slips[] = {
            [&](EmbeddedMesh& m) { m.mesh.tetrahedra[0][3] = wrong < 5 ? wrong : wrong + 100; },
            [&](EmbeddedMesh& m) { m.vertex_parents[1] = wrong; },
            [&](EmbeddedMesh& m) { m.parents[0] = wrong; },
            [&](EmbeddedMesh& m) { m.vertex_parents.pop_back(); },
            [&](EmbeddedMesh& m) { m.parents.push_back(0); },
            [&](EmbeddedMesh& m) { m.real.pop_back(); },
            [&](EmbeddedMesh& m) { m.fractions.clear(); },
            [&](EmbeddedMesh& m) {
                m.real[0] = {0, 0, 0, 0};
            },
        };
        for (const auto& slip : slips) {
            CAPTURE(wrong, &slip - slips);
            EmbeddedMesh embedded = right_embedding();
            slip(embedded);
            REQUIRE_THROWS_AS(checked_embedding(embedded, pair_of_tetrahedra()), std::out_of_range);
        }
    }
}

} // namespace rigor
