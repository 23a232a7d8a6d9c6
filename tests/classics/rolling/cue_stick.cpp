// SPDX-License-Identifier: MIT
// A billiard ball that a cue strikes level at the height b above its center rolls at once if
// b = 2/5 R (Coriolis 1835). Struck elsewhere it slips, and rolls in the end with 5/7 (1 + b/R) of
// its first speed.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a ball that is struck at seven tenths of its height rolls", "[classics]")
{
    const double R = 0.03, v = 1, mu = 0.2;
    for (const double share : {-0.5, 0., 0.4, 0.8}) // b/R
        for (const double h : {0.01, 0.0025}) {
            CAPTURE(share, h);
            RigidBody ball = body_of(Sphere{R}, {0, R, 0}, {0, mu});
            AppliedForce strike; // an impulse in the first step
            strike.body = 1;
            strike.force = {ball.mass * v / h, 0, 0};
            strike.torque = {0, 0, -share * R * strike.force.x()};
            strike.end = h;
            World world = solved({fixed(Plane{}, {0, mu}), ball});
            world.forces = {strike};
            run_until(world, 2, h);
            CHECK_THAT(world.bodies[1].state.velocity.x(),
                       IsClose(5. / 7 * (1 + share) * v, Order(1e-6)));
        }
}
