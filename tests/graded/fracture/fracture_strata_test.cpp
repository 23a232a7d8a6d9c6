// SPDX-License-Identifier: MIT
// A7: many neighbours and many elements, small neighbours under a high stress, a threshold that is
// met exactly, and which edges decide what is near a plane.
#include "formulas/fracture.hpp"
#include "fracture_laws.hpp"
#include "support/seeds.hpp"

namespace fracture_strata_test {

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("fracture: an element may have any number of neighbours", "[A7.1][fracture]")
{
    for (const int n : {3, 4, 5, 12, 500}) {
        CAPTURE(n);
        const std::vector<Matrix3d> stresses(static_cast<std::size_t>(n) + 1, Matrix3d::Identity());
        std::vector<Matrix3d> one = stresses;
        std::vector<std::vector<int>> neighbours(one.size());
        for (int i = 1; i <= n; ++i)
            neighbours[0].push_back(i);
        one[n].setZero(); // the last neighbour
        const std::vector<double> volumes(one.size(), 1.0);
        REQUIRE_THAT(smooth_stress(one, neighbours, volumes)[0],
                     IsClose(Matrix3d(n / (n + 1.0) * Matrix3d::Identity()), Rounding(4.0 * n)));
    }
}

TEST_CASE("fracture: a small neighbour under a high stress counts", "[A7.1][fracture]")
{
    for (int power = 1; power <= 48; ++power) {
        CAPTURE(power);
        const double small = std::ldexp(1, -power);
        const auto smooth =
            smooth_stress({Matrix3d::Zero(), Matrix3d::Identity() / small}, {{1}, {0}}, {1, small});
        for (const Matrix3d& sigma : smooth)
            REQUIRE_THAT(sigma,
                         IsClose(Matrix3d(Matrix3d::Identity() / (1 + small)), Rounding(16)));
    }
}

TEST_CASE("fracture: the stress of every element of many is smoothed", "[A7.1][fracture]")
{
    constexpr int n = 4000; // a ring, in which every second element is under stress
    std::vector<Matrix3d> stresses;
    std::vector<std::vector<int>> neighbours;
    for (int i = 0; i < n; ++i) {
        stresses.push_back((i % 2) * Matrix3d::Identity());
        neighbours.push_back({(i + 1) % n, (i + n - 1) % n});
    }
    const auto smooth = smooth_stress(stresses, neighbours, std::vector<double>(n, 1.0));
    REQUIRE(smooth.size() == n);
    for (int i = 0; i < n; ++i)
        REQUIRE_THAT(smooth[i](0, 0), IsClose(i % 2 == 0 ? 2.0 / 3 : 1.0 / 3, Rounding(16)));
}

TEST_CASE("fracture: a stress equal to the threshold opens no crack", "[A7.3][fracture]")
{
    for (const double stress : {0x1p-40, 1.0, 4.0, 0x1p40}) {
        CAPTURE(stress);
        const Matrix3d sigma = Vector3d(stress / 4, stress, -stress).asDiagonal();
        REQUIRE(!crack_plane(sigma, stress).has_value());
        REQUIRE(crack_plane(sigma, stress * (1 - 0x1p-40)).has_value());
    }
}

namespace {

// Two tetrahedra around vertex 0 with a face in common. Vertex 1 is `height` above the plane
// through vertex 0 that is perpendicular to y; the others are below it. The longest edge leads from
// vertex 0 to vertex 4 and is 20 m long.
TetrahedralMesh near_and_long(double height)
{
    TetrahedralMesh mesh = {{{0, 0, 0}, {0, height, 1}, {1, -2, 0}, {-1, -2, 0}, {0, -12, -16}},
                            {}};
    for (const Tetrahedron& t : {Tetrahedron{0, 1, 2, 3}, Tetrahedron{0, 4, 2, 3}}) {
        mesh.tetrahedra.push_back(t);
        if (volume(mesh, mesh.tetrahedra.size() - 1) < 0)
            std::swap(mesh.tetrahedra.back()[2], mesh.tetrahedra.back()[3]);
    }
    return mesh;
}

} // namespace

TEST_CASE("fracture: the longest edge of all tetrahedra of the vertex decides", "[A7.6][fracture]")
{
    // The tetrahedron of vertex 1 has no edge of 20 m; the other one has.
    for (const double height : {0.25, 0.5, 0.75, 0.99, 1.0, 1.01, 1.5}) { // 1 = 0.05 · 20
        CAPTURE(height);
        const TetrahedralMesh mesh = near_and_long(height);
        const SplitMesh result = split_element(mesh, 0, Vector3d::UnitY());
        const bool cuts = height >= 1; // less than 0.05 of the edge would be on the plane
        REQUIRE((vertex_count(result.mesh) > vertex_count(mesh)) == cuts);
        REQUIRE((piece_count(result.mesh) == 2) == cuts);
    }
}

} // namespace fracture_strata_test
