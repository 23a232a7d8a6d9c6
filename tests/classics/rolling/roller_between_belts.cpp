// SPDX-License-Identifier: MIT
// A roller between a belt and a heavy plank goes with the mean of their speeds and turns with
// half of their difference over its radius (the planet wheel of a gear).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a roller between a belt and a plank goes with their mean", "[classics]")
{
    const double R = 0.2, below = 0.6;
    const Material rough{0, 2};
    const Quaternion lying = turn({1, 0, 0}, pi / 2);
    for (const double above : {2., -1., 0.}) {
        CAPTURE(above);
        Drive belt = moving({below, 0, 0});
        belt.is_belt = true;
        std::vector<RigidBody> bodies = {driven(Box{{60, 1, 1}}, rough, {0, -0.5, 0}, belt),
                                         body_of(Box{{60, 0.1, 1}}, {0, 2 * R + 0.05, 0}, rough)};
        bodies[1].state.velocity = {above, 0, 0};
        set_mass(bodies[1], 1e6, 1e8 * Matrix3d::Identity());
        for (const double x : {-5., 5.}) {
            bodies.push_back(body_of(Cylinder{R, 0.6}, {x, R, 0}, rough, lying));
            bodies.back().state.velocity = {(above + below) / 2, 0, 0};
            spin(bodies.back(), {0, 0, (below - above) / (2 * R)});
        }
        World world = solved(bodies);
        run_until(world, 1.5, 0.005);
        for (const int i : {2, 3}) {
            CHECK_THAT(world.bodies[i].state.velocity.x(),
                       IsClose((above + below) / 2, Order(1e-4)));
            CHECK_THAT(angular_velocity(world.bodies[i]).z(),
                       IsClose((below - above) / (2 * R), Order(1e-3)));
        }
    }
}
