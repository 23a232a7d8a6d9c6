// SPDX-License-Identifier: MIT
#include "geometry/distance/signed_distance.hpp"
#include "geometry/level_sets/level_set.hpp"
#include "geometry/meshes/generators.hpp"
#include "geometry/meshes/mesh_surface.hpp"
#include "geometry/meshes/triangle.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

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

double distance_to_triangles(const TriangleMesh& mesh, const Vector3d& p)
{
    double best = 1e300;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
        best = std::min(best, (nearest_on(triangle_of(mesh, t), p).point - p).norm());
    return best;
}

// How often the surface winds around p: 1 inside, 0 outside.
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

const std::vector<TriangleMesh>& solids()
{
    static const std::vector<TriangleMesh> all = {box_mesh({1, 2, 0.5}),
                                                  icosphere(1, 1),
                                                  torus_mesh(1, 0.3, 16, 8),
                                                  ring_mesh(0.5, 1, 0.3, 12),
                                                  cross_mesh(1, 0.3),
                                                  bowl_mesh(1, 0.2, 12),
                                                  gear_mesh(8, 1, 0.3, 0.3),
                                                  angle_mesh({1, 1, 0.4}, 0.3),
                                                  voussoir_mesh(1, 1.4, 30, 0.5),
                                                  ring_mesh(0.2, 0.3, 2, 48)};
    return all;
}

} // namespace

TEST_CASE("level set: every node has the distance to the nearest triangle and its side",
          "[geometry]")
{
    for (const TriangleMesh& mesh : solids())
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
    CHECK(cells_for(box_mesh({1, 1, 1})) == 32);
    CHECK(cells_for(torus_mesh(1, 0.3, 48, 24)) == 32);
    CHECK(cells_for(bowl_mesh(1, 0.15, 48)) == 41); // 3 · 2/0.15, less for the bend of the facets
    CHECK(cells_for(box_mesh({1, 0.01, 1})) == 64);
}

TEST_CASE("level set: bodies of a mesh share one and it is made once", "[geometry]")
{
    const SolidMesh solid(cross_mesh(1, 0.3));
    int made = 0;
    const LevelSet& first = solid.level_set([&] { ++made; });
    const LevelSet& second = solid.level_set([&] { ++made; });
    CHECK(&first == &second);
    CHECK(made == 1);
}

TEST_CASE("surface: its points lie on it and no part of it is far from one", "[geometry]")
{
    const double spacing = 0.1;
    for (const TriangleMesh& mesh : solids()) {
        const MeshSurface surface(mesh, spacing);
        for (const SurfacePoint& p : surface.points())
            REQUIRE_THAT(distance_to_triangles(mesh, p.point), IsClose(0.0, Rounding(32, 4)));
        Random random(7);
        for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
            const Triangle triangle = triangle_of(mesh, t);
            const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
            const Vector3d p = (1 - u - v) * triangle.a + u * triangle.b + v * triangle.c;
            double nearest = 1e300;
            for (const SurfacePoint& q : surface.points())
                nearest = std::min(nearest, (q.point - p).norm());
            REQUIRE(nearest < 3 * spacing);
        }
    }
}

TEST_CASE("surface: sharp edges are those that stick out", "[geometry]")
{
    CHECK(MeshSurface(box_mesh({1, 1, 1}), 0.1).edges().size() == 12);
    CHECK(MeshSurface(angle_mesh({1, 1, 1}, 0.3), 0.1).edges().size() ==
          6 + 6 + 5); // not the inner one
    CHECK(MeshSurface(torus_mesh(1, 0.3, 64, 48), 0.1).edges().empty());
}

TEST_CASE("surface: a point is touched along its own normals only", "[geometry]")
{
    const TriangleMesh cube = box_mesh({2, 2, 2});
    const MeshSurface surface(cube, 0.5);
    for (unsigned seed = 0; seed < 20; ++seed)
        for (const SurfacePoint& p : surface.points()) {
            CAPTURE(seed, p.point.transpose());
            Random random(seed);
            const Vector3d d = random.unit_vector();
            const Vector3d n = surface.nearest_normal(p.cone, d);
            // of a box: what of d points out of the faces the point is on; a face alone has one normal
            Vector3d expected = Vector3d::Zero();
            int faces = 0, last = 0;
            for (int i = 0; i < 3; ++i) {
                if (std::abs(p.point[i]) < 1 - 1e-12) continue;
                ++faces;
                last = i;
                if (d[i] * p.point[i] > 0) expected[i] = d[i];
            }
            if (faces == 1) expected = Vector3d::Unit(last) * (p.point[last] < 0 ? -1 : 1);
            if (expected.norm() < 1e-3) continue; // from behind: any of them
            REQUIRE_THAT(n, IsClose(Vector3d(expected.normalized()), Rounding(1e5)));
        }
}
