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
        CHECK_THAT(top, IsClose(expected, Order(1e-8))); // the gap at an impact is at most 1e-11 m
    }
    CHECK(bounces == 3);
}

TEST_CASE("impact: a bounce at the very end of a step has its place", "[rigid]")
{
    // The ball reaches the floor after a whole number of steps, up to rounding.
    const double time_step = GENERATE(0.01, 0.005, 0.0025, 1. / 60, 1. / 64);
    const double speed = GENERATE(0.7, 1.0, 3.0, 4.0, 7.0, 20.0);
    const int steps = GENERATE(1, 2, 3, 5, 10);
    const double ulps = GENERATE(-2.0, -1.0, 0.0, 1.0, 2.0);
    CAPTURE(time_step, speed, steps, ulps);
    const double gap = steps * time_step * speed * (1 + ulps * 0x1p-52), radius = 0.1;
    World world = world_of(
        {fixed(Plane{}, {1, 0}), body_of(Sphere{radius}, {0, radius + gap, 0}, {1, 0})}, {0, 0, 0});
    world.bodies[1].state.velocity = {0, -speed, 0};
    run(world, 2 * steps + 1, time_step);
    const RigidState& ball = world.bodies[1].state;
    CHECK_THAT(ball.velocity.y(), IsClose(speed, Rounding(16)));
    CHECK_THAT(ball.position.y(),
               IsClose(radius + gap + speed * time_step, Rounding(1e4, radius + gap)));
}
