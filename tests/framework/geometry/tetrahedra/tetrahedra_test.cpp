// SPDX-License-Identifier: MIT
#include "geometry/tetrahedra/tetrahedra.hpp"
#include "geometry/tetrahedra/tetrahedra_checks.hpp"
#include "geometry/tetrahedra/tetrahedra_generators.hpp"

#include "geometry/meshes/mesh_checks.hpp"
#include "support/close.hpp"

#include <numbers>
#include <set>

using namespace rigor;
using namespace rigor::testing;

namespace {

double volume(const TetrahedralMesh& mesh)
{
    double sum = 0;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        sum += tetrahedron_volume(mesh, static_cast<int>(t));
    return sum;
}

std::string refusal(const TetrahedralMesh& mesh)
{
    try {
        check_mesh(mesh);
    } catch (const MeshError& error) {
        return error.what();
    }
    return "accepted";
}

TetrahedralMesh two_tetrahedra()
{
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{0, 1, 2, 3}, {4, 1, 3, 2}}};
}

// The positions of the vertices of each tetrahedron, in any order.
std::set<std::set<std::array<double, 3>>> places(const TetrahedralMesh& mesh, int mirrored_axis)
{
    std::set<std::set<std::array<double, 3>>> all;
    for (const auto& t : mesh.tetrahedra) {
        std::set<std::array<double, 3>> one;
        for (const int v : t) {
            Vector3d p = mesh.vertices[v];
            if (mirrored_axis >= 0) p[mirrored_axis] = -p[mirrored_axis];
            one.insert({p[0] + 0.0, p[1] + 0.0, p[2] + 0.0});
        }
        all.insert(one);
    }
    return all;
}

} // namespace

TEST_CASE("tetrahedra: generated meshes are solids of the right volume", "[geometry]")
{
    const TetrahedralMesh bar = block_tetrahedra({4, 1, 0.5}, {8, 3, 2});
    REQUIRE(refusal(bar) == "accepted");
    CHECK(bar.tetrahedra.size() == 5 * 8 * 3 * 2);
    CHECK_THAT(volume(bar), IsClose(2.0, Rounding(64)));
    CHECK_NOTHROW(check_mesh(boundary(bar)));
    CHECK_THAT(signed_volume(boundary(bar)), IsClose(2.0, Rounding(64)));

    const TetrahedralMesh notched = notched_tetrahedra({4, 2, 0.5}, {8, 4, 1}, {2, 3});
    REQUIRE(refusal(notched) == "accepted");
    CHECK_THAT(volume(notched), IsClose(4.0 * (1 - 6.0 / 32), Rounding(64)));

    for (const int layers : {1, 2, 3, 6}) {
        const TetrahedralMesh ball = ball_tetrahedra(2, layers);
        CAPTURE(layers);
        REQUIRE(refusal(ball) == "accepted");
        CHECK(static_cast<int>(ball.tetrahedra.size()) == 8 * layers * layers * layers);
        check_at_most(volume(ball), 4.0 / 3 * std::numbers::pi * 8, "volume");
    }
    check_at_most(0.93, volume(ball_tetrahedra(1, 6)) / (4.0 / 3 * std::numbers::pi), "share");
}

TEST_CASE("tetrahedra: generated meshes are their own mirror images", "[geometry]")
{
    for (const TetrahedralMesh& mesh :
         {block_tetrahedra({4, 1, 0.5}, {8, 4, 2}), ball_tetrahedra(1, 3),
          notched_tetrahedra({4, 2, 0.5}, {8, 4, 2}, {2, 2})})
        for (int axis = 0; axis < 3; ++axis) {
            CAPTURE(axis);
            if (axis != 1 || mesh.tetrahedra.size() != 5 * (8 * 4 - 4) * 2) // notch on top only
                CHECK(places(mesh, axis) == places(mesh, -1));
        }
}

TEST_CASE("tetrahedra: a mesh that is no solid is refused", "[geometry]")
{
    CHECK(refusal(two_tetrahedra()) == "accepted");
    CHECK(refusal({}) == "expected a mesh of tetrahedra, found none");

    TetrahedralMesh mesh = two_tetrahedra();
    mesh.tetrahedra[1][2] = 7;
    CHECK(refusal(mesh) == "expected vertices from 1 to 5, found 8 in tetrahedron 2");

    mesh = two_tetrahedra();
    mesh.vertices[4] = {0.5, 0.25, 0.25};
    CHECK(refusal(mesh) == "expected a tetrahedron with a volume, found tetrahedron 2 flat");

    mesh = two_tetrahedra();
    std::swap(mesh.tetrahedra[1][0], mesh.tetrahedra[1][1]);
    CHECK(refusal(mesh) ==
          "expected a tetrahedron with its fourth vertex where the first three turn "
          "counter-clockwise, found tetrahedron 2 inverted: its volume is -0.333333 m³");

    mesh = two_tetrahedra();
    mesh.vertices.push_back({2, 0, 0});
    CHECK(refusal(mesh) == "expected a tetrahedron at each vertex, found none at vertex 6");

    mesh = two_tetrahedra();
    mesh.vertices[2].x() = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal(mesh) ==
          "expected coordinates of at most 1e12 in size, found other ones at vertex 3");

    mesh = two_tetrahedra();
    mesh.vertices.push_back({2, 2, 2});
    mesh.tetrahedra.push_back({5, 1, 3, 2});
    CHECK(refusal(mesh) ==
          "expected at most two tetrahedra at a face, found tetrahedron 3 as a third");

    mesh.tetrahedra.erase(mesh.tetrahedra.begin());
    mesh.vertices.erase(mesh.vertices.begin());
    for (auto& t : mesh.tetrahedra)
        for (int& v : t)
            --v;
    CHECK(refusal(mesh) == "expected tetrahedra on both sides of a face, found tetrahedron 1 and "
                           "tetrahedron 2 on the same");

    mesh = two_tetrahedra();
    for (const Vector3d& v : {Vector3d(0, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, -1, 0)})
        mesh.vertices.push_back(v);
    mesh.tetrahedra.push_back({5, 6, 7, 3});
    CHECK(refusal(mesh) == "expected one solid, found tetrahedron 3 joined to tetrahedron 1 by no "
                           "chain of faces");
}
