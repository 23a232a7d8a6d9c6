// SPDX-License-Identifier: MIT
// A ball that sticks in a block on a spring pushes it by m v/√(k (M + m)) (Robins 1742, "New
// principles of gunnery", with a pendulum in the place of the spring).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a shot into a block on a spring is measured by its swing", "[classics]")
{
    const double m = 2, M = 12, k = 500, v = 8;
    for (const double h : {0.005, 0.0005}) {
        CAPTURE(h);
        RigidBody block = body_of(Box{{0.4, 0.4, 0.4}}, {0, 0, 0}, {0, 0});
        set_mass(block, M, block.inertia * (M / block.mass));
        RigidBody ball = ball_of_mass(0.1, m, {-0.4, 0, 0}, {0, 0});
        ball.state.velocity = {v, 0, 0};
        World world = solved({block, ball}, {0, 0, 0});
        world.springs = {{0, -1, {0, 0, 0}, {2, 0, 0}, k, 0, 2}};
        double farthest = 0;
        for (int i = 0; i * h < 0.5; ++i) {
            step(world, h);
            farthest = std::max(farthest, world.bodies[0].state.position.x());
        }
        CHECK_THAT(farthest, IsClose(m * v / std::sqrt(k * (M + m)), Order(0.02 * h / 0.005)));
    }
}
