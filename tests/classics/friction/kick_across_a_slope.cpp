// SPDX-License-Identifier: MIT
// A block that friction just holds on its slope, tan α = μ, is kicked across it: it turns downhill
// and ends with half of its speed, since the sum of its speed and its speed downhill stays
// (Irodov, "Problems in general physics", 1.89; Morin, "Classical mechanics").
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a block that is kicked across a slope ends with half its speed", "[classics]")
{
    const double angle = 0.4, mu = std::tan(angle);
    for (const double v : {0.5, 2., 5.}) {
        std::vector<double> errors;
        for (const double h : {0.02, 0.01, 0.005}) {
            RigidBody block = body_of(Box{{0.4, 0.001, 0.4}}, {0, 0.0005, 0}, {0, mu});
            block.state.velocity = {0, 0, v};
            World world = solved({fixed(Plane{}, {0, mu}), block}, gravity_on_slope(angle));
            double off = 0;
            while (world.time < 2 * v) {
                step(world, h);
                const Vector3d& V = world.bodies[1].state.velocity;
                off = std::max(off, std::abs(V.norm() + V.x() - v));
            }
            CAPTURE(h, v);
            check_at_most(std::abs(world.bodies[1].state.velocity.x() - v / 2), 0.01 * v, "error");
            errors.push_back(off);
        }
        CAPTURE(errors, v);
        check_order(errors, 2);
        check_at_most(errors[1], 1e-3 * v, "error of the sum at the default step [m/s]");
    }
}
