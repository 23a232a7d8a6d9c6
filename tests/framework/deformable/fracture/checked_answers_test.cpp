// SPDX-License-Identifier: MIT
// Wrong answers of the formulas of fracture are refused before the engine indexes with them.
#include "deformable/fracture/checked_answers.hpp"
#include "formulas/fracture.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <functional>
#include <limits>
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

TEST_CASE("checked answers: a mesh that vanishes is refused")
{
    const TetrahedralMesh mesh = pair_of_tetrahedra();
    REQUIRE_THROWS_WITH(
        checked_split_element({}, mesh),
        "split_element returned 0 parts of tetrahedron 0 where 1 to 6 were expected");
    REQUIRE_THROWS_WITH(
        checked_embedding({}, mesh),
        "virtual_nodes returned 0 parts of tetrahedron 0 where 1 to 4 were expected");
    SplitMesh one = right_split(); // one of two tetrahedra is left, twice
    one.parents = {1, 1};
    REQUIRE_THROWS_AS(checked_split_element(one, mesh), std::out_of_range);
    REQUIRE_THROWS_WITH(checked_split_along_faces(one, mesh),
                        "split_along_faces returned 0 parts of tetrahedron 0 where 1 was expected");
    EmbeddedMesh embedded = right_embedding();
    for (int& parent : embedded.parents)
        parent = 0;
    REQUIRE_THROWS_AS(checked_embedding(embedded, mesh), std::out_of_range);
    REQUIRE(checked_split_element({}, {}).parents.empty()); // nothing was there
}

TEST_CASE("checked answers: a cut makes six parts of a tetrahedron at most")
{
    // Two corners on each side of the plane: two wedges of three tetrahedra.
    const TetrahedralMesh whole = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
    SplitMesh split{whole, {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}}, {0}};
    for (int parts = 1; parts <= 7; ++parts) {
        CAPTURE(parts);
        if (parts <= 6)
            REQUIRE(checked_split_element(split, whole).parents.size() == split.parents.size());
        else
            REQUIRE_THROWS_AS(checked_split_element(split, whole), std::out_of_range);
        split.mesh.tetrahedra.push_back(split.mesh.tetrahedra[0]);
        split.parents.push_back(0);
    }
}

TEST_CASE("checked answers: vertices that no element can have are refused")
{
    const TetrahedralMesh mesh = pair_of_tetrahedra();
    SplitMesh split = right_split();
    split.mesh.vertices.resize(5 + 4 * 2, Vector3d::Zero());
    split.origins.resize(split.mesh.vertices.size());
    REQUIRE(checked_split_along_faces(split, mesh).origins.size() == 13);
    split.mesh.vertices.emplace_back(0, 0, 0);
    split.origins.emplace_back();
    const std::string text = " returned 14 vertices where at most 13 were expected";
    REQUIRE_THROWS_WITH(checked_split_along_faces(split, mesh), "split_along_faces" + text);
    REQUIRE_THROWS_WITH(checked_split_element(split, mesh), "split_element" + text);
    EmbeddedMesh embedded = right_embedding();
    embedded.mesh.vertices.resize(1'000'000, Vector3d::Zero());
    embedded.vertex_parents.resize(1'000'000, 0);
    REQUIRE_THROWS_AS(checked_embedding(embedded, mesh), std::out_of_range);
}

TEST_CASE("checked answers: numbers that no crack has are refused")
{
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
    const TetrahedralMesh mesh = pair_of_tetrahedra();
    REQUIRE_FALSE(checked_normal({}).has_value());
    REQUIRE(checked_normal(Vector3d(0, 1, 0)) == Vector3d(0, 1, 0));
    for (const double wrong : {nan, infinity, -infinity, 1e300, -1e300, -0.1, 1.1}) {
        CAPTURE(wrong);
        EmbeddedMesh embedded = right_embedding();
        embedded.fractions[0] = wrong;
        REQUIRE_THROWS_AS(checked_embedding(embedded, mesh), std::out_of_range);
        SplitMesh split = right_split();
        split.origins[0].fraction = wrong;
        REQUIRE_THROWS_AS(checked_split_element(split, mesh), std::out_of_range);
        if (std::isfinite(wrong)) continue;
        REQUIRE_THROWS_WITH(checked_normal(Vector3d(0, wrong, 1)),
                            "crack_plane returned a normal that is not finite");
        split = right_split();
        split.mesh.vertices[1].x() = wrong;
        REQUIRE_THROWS_WITH(checked_split_element(split, mesh),
                            "split_element returned a place that is not finite, of vertex 1");
    }
    for (const int wrong : {-1, 2, std::numeric_limits<int>::max()}) {
        EmbeddedMesh embedded = right_embedding();
        embedded.real[0][3] = wrong;
        REQUIRE_THROWS_AS(checked_embedding(embedded, mesh), std::out_of_range);
    }
}

} // namespace rigor
