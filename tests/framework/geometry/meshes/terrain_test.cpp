// SPDX-License-Identifier: MIT
#include "geometry/meshes/terrain.hpp"

#include "geometry/meshes/mesh_checks.hpp"
#include "support/catch.hpp"

#include <cmath>

namespace terrain_test {

using namespace rigor;

namespace {

// A field of n × n squares of edge 1, at the heights of a function of x and z.
template <class Height> TriangleMesh field(int n, const Height& height)
{
    TriangleMesh mesh;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
            mesh.vertices.emplace_back(i, height(i, j), j);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const int a = i * (n + 1) + j, b = a + 1, c = a + n + 1, d = c + 1;
            mesh.triangles.push_back({a, b, d});
            mesh.triangles.push_back({a, d, c});
        }
    return mesh;
}

} // namespace

TEST_CASE("terrain: the solid below a surface is closed and has its volume", "[geometry]")
{
    // Over a plane of any slope the mean height is that of the middle.
    const TriangleMesh slope = field(4, [](int x, int z) { return 0.5 * x - 0.25 * z; });
    const TriangleMesh solid = solid_below(slope, 2);
    CHECK_NOTHROW(check_mesh(solid));
    const double lowest = -1, middle = 0.5;
    CHECK(std::abs(signed_volume(solid) - 16 * (middle - lowest + 2)) < 1e-12);

    TriangleMesh hole = field(5, [](int x, int z) { return std::sin(x) * std::cos(z); });
    hole.triangles.erase(hole.triangles.begin() + 24, hole.triangles.begin() + 26);
    CHECK_NOTHROW(check_mesh(solid_below(hole, 0.1))); // a shaft with walls
}

TEST_CASE("terrain: a surface that is not seen from above is refused", "[geometry]")
{
    TriangleMesh turned = field(2, [](int, int) { return 0.0; });
    std::swap(turned.triangles[3][0], turned.triangles[3][1]);
    std::vector<int> lines(8);
    lines[3] = 17;
    try {
        solid_below(turned, 1, lines);
        FAIL("accepted");
    } catch (const MeshError& error) {
        CHECK(error.line == 17);
        CHECK(std::string(error.what()) ==
              "expected a terrain whose faces turn counter-clockwise seen from above, found one "
              "that does not");
    }
}

} // namespace terrain_test
