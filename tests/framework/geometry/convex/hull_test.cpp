// SPDX-License-Identifier: MIT
#include "geometry/convex/hull.hpp"
#include "geometry/meshes/generators.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

#include <algorithm>

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("hull: a mesh with a dent is none", "[geometry]")
{
    CHECK(is_hull(box_mesh({1, 2, 3})));
    CHECK(is_hull(icosphere(1, 2)));
    CHECK_FALSE(is_hull(cross_mesh(3, 1)));
    CHECK_FALSE(is_hull(torus_mesh(1, 0.3, 12, 6)));
}

TEST_CASE("hull: the search from vertex to vertex ends at the farthest", "[geometry]")
{
    for (const TriangleMesh& mesh : {box_mesh({1, 2, 3}), icosphere(1, 2)}) {
        const Hull hull(mesh);
        for (unsigned seed = 0; seed < 50; ++seed) {
            CAPTURE(seed);
            const Vector3d d = Random(seed).unit_vector();
            double farthest = -1e300;
            for (const Vector3d& v : mesh.vertices)
                farthest = std::max(farthest, d.dot(v));
            REQUIRE_THAT(d.dot(hull.support(d)), IsClose(farthest, Rounding(4)));
        }
    }
}

TEST_CASE("hull: the triangles of a flat face are one face", "[geometry]")
{
    const Hull box(box_mesh({1, 2, 3}));
    CHECK(box.face_normals().size() == 6);
    const Feature top = box.feature_towards(Vector3d::UnitY());
    REQUIRE(top.count == 4);
    for (int i = 0; i < 4; ++i)
        CHECK_THAT(top.points[i].y(), IsClose(1.0, Rounding(4)));
    CHECK(box.feature_towards(Vector3d(1, 1, 0).normalized()).count == 2);
    CHECK(box.feature_towards(Vector3d(1, 1, 1).normalized()).count == 1);
}
