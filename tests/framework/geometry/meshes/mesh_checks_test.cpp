// SPDX-License-Identifier: MIT
#include "geometry/meshes/generators.hpp"
#include "geometry/meshes/mesh_checks.hpp"
#include "support/close.hpp"

#include <limits>

using namespace rigor;
using namespace rigor::testing;

namespace {

std::string refusal(const TriangleMesh& mesh, const std::vector<int>& lines = {})
{
    try {
        check_mesh(mesh, lines);
    } catch (const MeshError& error) {
        return (error.line > 0 ? std::to_string(error.line) + ": " : "") + error.what();
    }
    return "accepted";
}

bool begins(const std::string& text, const std::string& start)
{
    return text.rfind(start, 0) == 0;
}

TriangleMesh moved(TriangleMesh mesh, const Vector3d& by)
{
    for (Vector3d& v : mesh.vertices)
        v += by;
    return mesh;
}

TriangleMesh turned_around(TriangleMesh mesh)
{
    for (auto& triangle : mesh.triangles)
        std::swap(triangle[0], triangle[1]);
    return mesh;
}

TriangleMesh both(TriangleMesh a, const TriangleMesh& b)
{
    const int n = static_cast<int>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& [i, j, k] : b.triangles)
        a.triangles.push_back({n + i, n + j, n + k});
    return a;
}

const TriangleMesh cube = box_mesh({1, 1, 1});

} // namespace

TEST_CASE("mesh check: solids pass", "[geometry]")
{
    for (const TriangleMesh& mesh :
         {cube, icosphere(1, 3), torus_mesh(2, 0.5, 24, 12), cross_mesh(3, 1),
          moved(icosphere(1e-4, 2), {1e3, 0, 0}), both(cube, moved(cube, {3, 0, 0})),
          both(cube, turned_around(icosphere(0.4, 1)))})
        CHECK(refusal(mesh) == "accepted");
}

TEST_CASE("mesh check: an open surface is refused at its border", "[geometry]")
{
    TriangleMesh open = cube;
    open.triangles.pop_back();
    CHECK(begins(refusal(open), "expected a closed surface, found the edge from ("));
    CHECK(begins(refusal(open, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}), "11: expected a closed"));
}

TEST_CASE("mesh check: faces that turn the wrong way are refused", "[geometry]")
{
    CHECK(refusal(turned_around(cube)) ==
          "expected faces that turn counter-clockwise seen from outside, found a volume of -1 m³: "
          "flip all faces");
    TriangleMesh one = cube;
    std::swap(one.triangles[5][0], one.triangles[5][1]);
    const std::string message = refusal(one);
    CHECK(begins(message, "expected a consistent winding, found the edge from"));
    CHECK(message.find("face 6") != std::string::npos);
}

TEST_CASE("mesh check: a face without an area is refused", "[geometry]")
{
    TriangleMesh flat = cube;
    flat.vertices.push_back((flat.vertices[0] + flat.vertices[1]) / 2);
    flat.triangles.push_back({0, 8, 1});
    CHECK(refusal(flat) == "expected a face with an area, found none at (-0.5, -0.5, -0.5)");
    flat.triangles.back() = {0, 0, 1};
    CHECK(begins(refusal(flat), "expected a face with an area"));
}

TEST_CASE("mesh check: numbers that are none are refused", "[geometry]")
{
    for (const double x :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        TriangleMesh broken = cube;
        broken.vertices[3].y() = x;
        CHECK(begins(refusal(broken), "expected finite vertices, found one at ("));
    }
    TriangleMesh outside = cube;
    outside.triangles[4][2] = 8;
    CHECK(refusal(outside) == "expected vertices from 1 to 8, found 9");
    outside.triangles[4][2] = -1;
    CHECK(refusal(outside) == "expected vertices from 1 to 8, found 0");
    CHECK(refusal({}) == "expected a mesh with faces, found none");
}

TEST_CASE("mesh check: more than two faces at an edge are refused", "[geometry]")
{
    // Two cubes share the vertices of an edge.
    TriangleMesh pair = both(cube, moved(cube, {1, 1, 0}));
    for (auto& triangle : pair.triangles)
        for (int& v : triangle)
            for (int shared = 0; shared < 8; ++shared)
                if (v >= 8 && (pair.vertices[v] - pair.vertices[shared]).norm() == 0) v = shared;
    CHECK(begins(refusal(pair), "expected two faces at each edge, found 4 at the one from"));
}

TEST_CASE("mesh check: a surface that goes through itself is refused", "[geometry]")
{
    const std::string message = "expected a surface that does not go through itself, found";
    CHECK(begins(refusal(both(cube, moved(cube, {0.5, 0.5, 0.5}))), message));
    CHECK(begins(refusal(both(cube, moved(box_mesh({0.2, 0.2, 3}), {0.1, 0.05, 0}))), message));
    TriangleMesh dented = icosphere(1, 2);
    dented.vertices[5] *= -1.5; // a vertex is moved through to the other side
    CHECK(begins(refusal(dented), message));
}

TEST_CASE("mesh check: matter within matter is refused and a hollow is none", "[geometry]")
{
    CHECK(begins(refusal(both(box_mesh({3, 3, 3}), cube)),
                 "expected pieces that lie apart, or hollows whose faces look inwards, found"));
    CHECK(begins(refusal(both(box_mesh({3, 3, 3}), turned_around(moved(cube, {5, 0, 0})))),
                 "expected pieces that lie apart"));
}

TEST_CASE("mesh check: volume is exact", "[geometry]")
{
    CHECK_THAT(signed_volume(moved(box_mesh({1, 2, 3}), {100, 0, 0})),
               IsClose(6.0, Rounding(64, 600)));
    const double ball = 4.0 / 3 * std::numbers::pi;
    const double known[] = {0.6054613829, 0.8734532000, 0.9661607486, 0.9913938426};
    for (int level = 0; level < 4; ++level) // ten digits of the closed form
        CHECK_THAT(signed_volume(icosphere(1, level)) / ball, IsClose(known[level], Order(5e-11)));
}
