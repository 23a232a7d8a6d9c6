// SPDX-License-Identifier: MIT
// A block that is pushed up a rough slope comes back slower, by √((tan α - μ)/(tan α + μ)): up it
// is braked by g (sin α + μ cos α), down it is pulled by g (sin α - μ cos α).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a block comes back slower from a rough slope", "[classics]")
{
    const double v = 2, angle = 0.5;
    for (const double mu : {0.1, 0.4})
        for (const double h : {0.01, 0.001}) {
            CAPTURE(mu, h);
            RigidBody block = body_of(Box{{0.4, 0.05, 0.4}}, {0, 0.025, 0}, {0, mu});
            block.state.velocity = {-v, 0, 0};
            World world = solved({fixed(Plane{}, {0, mu}), block}, gravity_on_slope(angle));
            const double up = g * (std::sin(angle) + mu * std::cos(angle));
            const double down = g * (std::sin(angle) - mu * std::cos(angle));
            double highest = 0;
            while (world.bodies[1].state.velocity.x() <= 0 ||
                   world.bodies[1].state.position.x() < 0) {
                step(world, h);
                REQUIRE(world.time < 10);
                highest = std::min(highest, world.bodies[1].state.position.x());
            }
            CHECK_THAT(-highest, IsClose(v * v / (2 * up), Order(v * h)));
            const double x = world.bodies[1].state.position.x();
            CHECK_THAT(world.bodies[1].state.velocity.x(),
                       IsClose(std::sqrt(v * v * down / up + 2 * down * x), Order(20 * h)));
        }
}
