// SPDX-License-Identifier: MIT
#include "framework/geometry/meshes/solid_meshes.hpp"
#include "geometry/meshes/mesh_surface.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("surface: its points lie on it and no part of it is far from one", "[geometry]")
{
    const double spacing = 0.1;
    for (const TriangleMesh& mesh : solid_meshes()) {
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
          6 + 6 + 5); // without the inner edge
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
            // For a box, the direction is that of the components of d that point out of the faces
            // at this point. On a single face, the direction is the normal of the face.
            Vector3d expected = Vector3d::Zero();
            int faces = 0, last = 0;
            for (int i = 0; i < 3; ++i) {
                if (std::abs(p.point[i]) < 1 - 1e-12) continue;
                ++faces;
                last = i;
                if (d[i] * p.point[i] > 0) expected[i] = d[i];
            }
            if (faces == 1) expected = Vector3d::Unit(last) * (p.point[last] < 0 ? -1 : 1);
            if (expected.norm() < 1e-3) continue; // from inside, any normal is allowed
            REQUIRE_THAT(n, IsClose(Vector3d(expected.normalized()), Rounding(1e5)));
        }
}
