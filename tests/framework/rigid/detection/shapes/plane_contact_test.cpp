// SPDX-License-Identifier: MIT
#include "framework/rigid/contact_shapes.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("plane contact: a box touches a plane with its vertices", "[rigid]")
{
    const Box box{{1, 2, 3}};
    for (unsigned seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Pose pose = random_pose(random, 1), plane = random_pose(random, 1);
        const auto touches = touches_of(box, pose, Plane{}, plane, 0);
        std::size_t below = 0;
        for (const Vector3d& corner : corners(box, pose)) {
            const double gap = (plane.R.transpose() * (corner - plane.X)).y();
            if (gap >= 0) continue;
            REQUIRE(below < touches.size());
            REQUIRE_THAT(touches[below].gap, IsClose(gap, Rounding(16, 4)));
            REQUIRE_THAT(touches[below].point, IsClose(corner, Rounding(16)));
            ++below;
        }
        REQUIRE(below == touches.size());
    }
}

TEST_CASE("plane contact: on a plane the deepest touch of a shape is its lowest point", "[rigid]")
{
    for (const NamedShape& named : all_shapes())
        for (unsigned seed = 0; seed < 30; ++seed) {
            CAPTURE(named.name, seed);
            Random random(seed);
            const Pose pose{random.rotation(), random.vector()},
                plane{random.rotation(), random.vector()};
            const Vector3d n = plane.R.col(1);
            const double lowest =
                n.dot(pose.X - plane.X) - reach_along(named.shape, pose.R.transpose() * -n);
            const auto touches = touches_of(named.shape, pose, Plane{}, plane);
            REQUIRE(!touches.empty());
            REQUIRE(touches.size() <= 18);
            // The deepest of the contacts that were kept is as deep as the lowest point.
            REQUIRE_THAT(deepest(touches), IsClose(lowest, Order(3e-5)));
            for (const Contact& t : touches) {
                REQUIRE_THAT(t.normal, IsExactly(n));
                REQUIRE_THAT(n.dot(t.point - plane.X), IsClose(t.gap, Rounding(64, 8)));
            }
            REQUIRE(touches_of(named.shape, pose, Plane{}, plane, lowest - 1e-12).empty());
        }
}
