// SPDX-License-Identifier: MIT
// A block that is pushed at the height y slides if F > μ M g, and tips before that if
// y > W/(2 μ), by F > M g W/(2 y) (Lamb 1912, "Statics").
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a block that is pushed tips or slides by the height", "[classics]")
{
    const double W = 0.4, H = 1, mu = 0.4; // W/(2 μ) = 0.5 m
    for (const double y : {0.1, 0.45, 0.6, 0.9})
        for (const double share : {0.97, 1.03})
            for (const double h : {1 / 60., 1 / 240.}) {
                CAPTURE(y, share, h);
                RigidBody block = body_of(Box{{W, H, W}}, {0, H / 2, 0}, {0, mu});
                const double tips = block.mass * g * W / (2 * y), slides = mu * block.mass * g;
                World world = solved({fixed(Plane{}, {0, mu}), block});
                AppliedForce push;
                push.body = 1;
                push.force = {share * std::min(tips, slides), 0, 0};
                push.point = {0, y - H / 2, 0};
                world.forces = {push};
                run(world, static_cast<int>(1.5 / h), h);
                const RigidState& s = world.bodies[1].state;
                const double tilt = std::abs(s.orientation.v.z());
                if (share < 1) {
                    check_at_most((s.position - block.state.position).norm(), 1e-6, "way [m]");
                } else if (tips < slides) {
                    check_at_least(tilt, 0.02, "tilt");
                } else {
                    check_at_most(tilt, 1e-3, "tilt");
                    check_at_least(s.position.x(), 0.02, "way [m]");
                }
            }
}
