// SPDX-License-Identifier: MIT
#include "framework/geometry/meshes/solid_meshes.hpp"
#include "geometry/meshes/triangle_tree.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("triangle tree: the nearest point is that of all triangles", "[geometry]")
{
    for (const TriangleMesh& mesh : solid_meshes()) {
        const TriangleTree tree(mesh);
        for (unsigned seed = 0; seed < 20; ++seed) {
            CAPTURE(seed);
            const Vector3d p = Random(seed).vector();
            REQUIRE_THAT((tree.nearest(p).point - p).norm(),
                         IsClose(distance_to_triangles(mesh, p), Rounding(8, 2)));
        }
    }
}

TEST_CASE("triangle tree: a point between two walls has a local minimum on each", "[geometry]")
{
    const TriangleMesh mesh = box_mesh({1, 0.2, 1});
    const TriangleTree tree(mesh);
    const Vector3d p(0.1, 0.01, 0.2); // 0.09 m below the upper wall, 0.11 m above the lower one
    const auto minima = tree.local_minima(p, 0.15);
    REQUIRE(minima.size() == 2);
    CHECK_THAT(minima[0].point, IsClose(Vector3d(0.1, 0.1, 0.2), Rounding(8)));
    CHECK_THAT(minima[1].point, IsClose(Vector3d(0.1, -0.1, 0.2), Rounding(8)));
    CHECK(minima[0].triangle == tree.nearest(p).triangle);
    CHECK(tree.local_minima(p, 0.05).empty());
}
