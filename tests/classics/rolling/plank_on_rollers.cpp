// SPDX-License-Identifier: MIT
// A plank on rollers goes twice as fast as they do (the Egyptians' way of moving stones): pulled by
// F, it is accelerated by F/(M + n (m + I/r²)/4), 3/8 m for each solid roller.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a plank on rollers goes twice as fast as they do", "[classics]")
{
    const double r = 0.1, T = 0.8, F = 300;
    const Material rough{0, 5};
    const Quaternion lying = turn({1, 0, 0}, pi / 2);
    for (const double h : {0.01, 0.0025}) {
        CAPTURE(h);
        World world =
            solved({fixed(Plane{}, rough), body_of(Cylinder{r, 0.6}, {-0.6, r, 0}, rough, lying),
                    body_of(Cylinder{r, 0.6}, {0.6, r, 0}, rough, lying),
                    body_of(Box{{4, 0.1, 0.5}}, {0, 2 * r + 0.05, 0}, rough)});
        AppliedForce pull;
        pull.body = 3;
        pull.force = {F, 0, 0};
        pull.point = {0, -0.05, 0};
        world.forces = {pull};
        run_until(world, T, h);
        const double m = world.bodies[1].mass, M = world.bodies[3].mass;
        const double a = F / (M + 2 * 3. / 8 * m);
        CHECK_THAT(world.bodies[3].state.velocity.x(), IsClose(a * T, Order(1e-4)));
        for (const int i : {1, 2})
            CHECK_THAT(world.bodies[i].state.velocity.x(), IsClose(a * T / 2, Order(1e-4)));
    }
}
