// SPDX-License-Identifier: MIT
// A ball that meets a free rod at the distance b from its center feels the mass M/(1 + M b²/I), at
// the end of a thin rod a quarter of M. A ball of exactly that mass stops (Routh 1905, "Dynamics of
// a system of rigid bodies").
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a ball stops at the end of a rod four times as heavy", "[classics]")
{
    const Material elastic{1, 0};
    const double v = 3;
    RigidBody rod = body_of(Capsule{0.001, 1}, {0, 0, 0}, elastic);
    for (const double b : {0., 0.3, 0.5})
        for (const double share : {0.5, 1., 3.}) { // mass of the ball over the mass that it feels
            CAPTURE(b, share);
            const double felt = 1 / (1 / rod.mass + b * b / rod.inertia(2, 2));
            if (b == 0.5) CHECK_THAT(felt, IsClose(rod.mass / 4, Order(0.002 * rod.mass)));
            RigidBody ball = ball_of_mass(0.1, share * felt, {-0.4, b, 0}, elastic);
            ball.state.velocity = {v, 0, 0};
            World world = solved({rod, ball}, {0, 0, 0});
            run(world, 20, 0.01);
            CHECK_THAT(world.bodies[1].state.velocity.x(),
                       IsClose(v * (share - 1) / (share + 1), Rounding(1e5, v)));
            CHECK_THAT(totals(world).kinetic_energy,
                       IsClose(share * felt * v * v / 2, Rounding(1e5)));
        }
}
