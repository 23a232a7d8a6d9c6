// SPDX-License-Identifier: MIT
#include "framework/geometry/meshes/solid_meshes.hpp"
#include "geometry/distance/signed_distance.hpp"
#include "geometry/level_sets/level_set.hpp"
#include "support/close.hpp"

#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

template <class Visit> void for_nodes(const LevelSet& grid, const Visit& visit)
{
    std::size_t number = 0;
    for (int k = 0; k < grid.size[2]; ++k)
        for (int j = 0; j < grid.size[1]; ++j)
            for (int i = 0; i < grid.size[0]; ++i)
                visit(Vector3d(grid.origin + grid.cell_size * Vector3d(i, j, k)),
                      grid.distances[number++]);
    REQUIRE(number == grid.distances.size());
}

// The winding number of the surface around p: 1 inside, 0 outside.
double winding_number(const TriangleMesh& mesh, const Vector3d& p)
{
    double sum = 0;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        const Triangle triangle = triangle_of(mesh, t);
        const Vector3d a = triangle.a - p, b = triangle.b - p, c = triangle.c - p;
        const double l = a.norm(), m = b.norm(), n = c.norm();
        sum +=
            std::atan2(a.dot(b.cross(c)), l * m * n + a.dot(b) * n + b.dot(c) * l + c.dot(a) * m);
    }
    return sum / (2 * std::numbers::pi);
}

} // namespace

TEST_CASE("level set: every node has the distance to the nearest triangle and its side",
          "[geometry]")
{
    for (const TriangleMesh& mesh : solid_meshes())
        for_nodes(make_level_set(mesh, 9), [&](const Vector3d& p, double phi) {
            const double distance = distance_to_triangles(mesh, p);
            REQUIRE_THAT(std::abs(phi), IsClose(distance, Rounding(64, 4)));
            if (distance > 1e-9) REQUIRE((phi < 0) == (winding_number(mesh, p) > 0.5));
        });
}

TEST_CASE("level set: the grid holds the mesh with two cells around it", "[geometry]")
{
    const TriangleMesh mesh = box_mesh({1, 2, 0.5});
    const LevelSet grid = make_level_set(mesh, 16);
    CHECK_THAT(grid.cell_size, IsClose(2.0 / 16, Rounding(4)));
    CHECK(grid.size == std::array<int, 3>{8 + 5, 16 + 5, 4 + 5});
    CHECK_THAT(grid.origin, IsClose(Vector3d(-0.75, -1.25, -0.5), Rounding(8, 2)));
}

TEST_CASE("level set: a finer mesh comes nearer to the round shape", "[geometry]")
{
    const Torus torus{1, 0.3};
    std::vector<double> errors;
    for (const int n : {12, 24, 48}) {
        double worst = 0;
        for_nodes(make_level_set(torus_mesh(1, 0.3, 2 * n, n), 12),
                  [&](const Vector3d& p, double phi) {
                      worst = std::max(worst, std::abs(phi - signed_distance(torus, p).distance));
                  });
        errors.push_back(worst);
    }
    check_order(errors, 2);
    CHECK(errors.back() < 1e-2);
}

TEST_CASE("level set: thin walls ask for finer cells within limits", "[geometry]")
{
    CHECK(suggested_cells(box_mesh({1, 1, 1})) == 32);
    CHECK(suggested_cells(torus_mesh(1, 0.3, 48, 24)) == 32);
    CHECK(suggested_cells(bowl_mesh(1, 0.15, 48)) ==
          41); // 3 · 2/0.15, and a little more because facets are flat
    CHECK(suggested_cells(box_mesh({1, 0.01, 1})) == 64);
}
