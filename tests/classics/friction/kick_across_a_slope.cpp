// SPDX-License-Identifier: MIT
// A block that friction just holds on its slope, tan α = μ, is kicked across it: it turns downhill
// and ends with half of its speed, since the sum of its speed and its speed downhill stays
// (Irodov, "Problems in general physics", 1.89; Morin, "Classical mechanics").
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a block that is kicked across a slope ends with half its speed", "[classics]")
{
    const double v = 2, angle = 0.4, mu = std::tan(angle);
    std::vector<double> errors;
    for (const double h : {0.01, 0.005, 0.0025}) {
        RigidBody block = body_of(Box{{0.4, 0.001, 0.4}}, {0, 0.0005, 0}, {0, mu});
        block.state.velocity = {0, 0, v};
        World world = solved({fixed(Plane{}, {0, mu}), block}, gravity_on_slope(angle));
        double off = 0;
        for (int i = 0; i * h < 4; ++i) {
            step(world, h);
            const Vector3d& V = world.bodies[1].state.velocity;
            off = std::max(off, std::abs(V.norm() + V.x() - v));
        }
        CAPTURE(h);
        check_at_most(std::abs(world.bodies[1].state.velocity.x() - v / 2), 0.01 * v, "error");
        errors.push_back(off);
    }
    CAPTURE(errors);
    check_at_most(errors.back(), 0.005 * v, "error of the sum [m/s]");
    check_at_most(errors[2], 0.6 * errors[0], "error by a quarter of the step [m/s]");
}
