// SPDX-License-Identifier: MIT
// Weights balance at distances that are inversely as the weights (Archimedes, "On the
// equilibrium of planes"). The lever is a board that lies with its middle on a narrow support; what
// tips it is a moment beyond the reach of the support's edge.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a lever tips to the side of the larger moment", "[classics]")
{
    const double half = 0.02; // half the width of the support [m]
    for (const double ratio : {1., 2., 5.})
        for (const int side : {-1, 0, 1})
            for (const double h : {1 / 60., 1 / 240.}) {
                CAPTURE(ratio, side, h);
                const Material rough{0, 1};
                RigidBody board = body_of(Box{{2.4, 0.05, 0.3}}, {0, 0.025, 0}, rough);
                RigidBody heavy = body_of(Box{{0.1, 0.1, 0.1}}, {0, 0.1, 0}, rough), light = heavy;
                set_mass(board, 5, board.inertia * (5 / board.mass));
                const double m = 5, far = 1, near = far / ratio;
                set_mass(heavy, ratio * m, heavy.inertia * (ratio * m / heavy.mass));
                set_mass(light, m, light.inertia * (m / light.mass));
                // The moment beyond balance is 1.3 times what the edge of the support takes.
                const double total = board.mass + (ratio + 1) * m;
                light.state.position.x() = far + side * 1.3 * half * total / m;
                heavy.state.position.x() = -near;
                World world = solved(
                    {fixed(Box{{2 * half, 1, 1}}, rough, {0, -0.5, 0}), board, heavy, light});
                const double moment = m * light.state.position.x() - ratio * m * near;
                const bool tips = std::abs(moment) > half * total;
                CHECK(tips == (side != 0));
                run(world, static_cast<int>(1.5 / h), h);
                const double tilt = world.bodies[1].state.orientation.v.z();
                if (side == 0)
                    check_at_most(std::abs(tilt), 1e-6, "tilt");
                else
                    check_at_least(-side * tilt, 0.02, "tilt");
            }
}
