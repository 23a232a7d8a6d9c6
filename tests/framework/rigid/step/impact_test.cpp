// SPDX-License-Identifier: MIT
#include "framework/rigid/worlds.hpp"
#include "rigid/step/step.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("impact: a ball bounces where it meets the floor whatever the step", "[rigid]")
{
    const double epsilon = GENERATE(0.5, 0.8, 1.0);
    const double time_step = GENERATE(1e-3, 7e-3);
    World world =
        world_of({fixed(Plane{}, {epsilon, 0}), body_of(Sphere{0.1}, {0, 1.1, 0}, {epsilon, 0})});
    double expected = 1;
    int bounces = 0;
    for (int i = 0; i < 4000 && bounces < 3; ++i) {
        const double before = world.bodies[1].state.velocity.y();
        step(world, time_step);
        const RigidState& ball = world.bodies[1].state;
        if (before >= 0 || ball.velocity.y() <= 0) continue;
        ++bounces;
        expected *= epsilon * epsilon;
        // Height of the top of the ball's current parabola.
        const double top =
            ball.position.y() - 0.1 + ball.velocity.y() * ball.velocity.y() / (2 * g);
        CAPTURE(epsilon, time_step, bounces);
        CHECK_THAT(top, IsClose(expected, Order(1e-8))); // the time of impact is exact to 1e-10 m
    }
    CHECK(bounces == 3);
}
