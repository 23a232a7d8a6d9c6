// SPDX-License-Identifier: MIT
#include "rigid/detection/travel.hpp"

#include "formulas/rotation.hpp"
#include "framework/rigid/worlds.hpp"
#include "support/catch.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("travel: a path is at least as long as that of any point", "[rigid]")
{
    Random random(11);
    for (const double angle : {0., 1e-6, 0.1, 1., 3., 4., 6.28, 7., 9.42, 100.})
        for (int i = 0; i < 20; ++i) {
            CAPTURE(angle, i);
            const double radius = 2, h = 0.1;
            RigidState from, to;
            from.orientation = turn(random.unit_vector(), random.uniform(-3, 3));
            const Quaternion turned = turn(random.unit_vector(), angle);
            to.position = random.vector();
            to.orientation = multiply(from.orientation, turned);
            const Vector3d p = radius * random.unit_vector(); // on the surface
            const Vector3d moved = to.position + rotation_matrix(to.orientation) * p -
                                   rotation_matrix(from.orientation) * p;
            check_at_least(path_between(travel_of(from, to, angle, radius, h), {}), moved.norm(),
                           "path [m]");
        }
}

TEST_CASE("travel: a frame that moves changes no path", "[rigid]")
{
    const Vector3d frame(3, -4, 5);
    const Travel a{{1, 2, 3}, {2, 2, 2}, 0.25}, b{{0, 1, -1}, {1, 0, 1}, 0.5};
    const Travel a_seen{a.moved + frame, a.at_last_velocity + frame, a.turned};
    const Travel b_seen{b.moved + frame, b.at_last_velocity + frame, b.turned};
    CHECK(path_between(a_seen, b_seen) == path_between(a, b));
}

TEST_CASE("travel: bodies are measured against still ones, or their center of mass", "[rigid]")
{
    World world = world_of({body_of(Sphere{1}, {0, 0, 0}), body_of(Sphere{1}, {5, 0, 0})});
    std::vector<RigidState> flown = {world.bodies[0].state, world.bodies[1].state};
    flown[0].position.x() += 2;
    const std::vector<Travel> center = frames_of(world, flown, 0.1);
    REQUIRE(center.size() == 1);
    CHECK(center[0].moved == Vector3d(1, 0, 0)); // equal masses
    CHECK(frame_of_bounds(world, center) == Vector3d(1, 0, 0));

    world.bodies.push_back(fixed(Plane{}, {}));
    flown.push_back(world.bodies[2].state);
    const std::vector<Travel> still = frames_of(world, flown, 0.1);
    REQUIRE(still.size() == 1);
    CHECK(still[0].moved.isZero(0));
    CHECK(frame_of_bounds(world, still).isZero(0));
}
