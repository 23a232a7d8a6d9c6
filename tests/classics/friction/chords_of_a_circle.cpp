// SPDX-License-Identifier: MIT
// Down every chord from the highest point of a circle a body slides in the same time, √(2 D/g) with
// the diameter D (Galilei 1638, "Discorsi", theorem 6).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: every chord of a circle takes the same time", "[classics]")
{
    const double D = 2, T = std::sqrt(2 * D / g);
    for (const double from_vertical : {0.2, 0.7, 1.2, 1.5})
        for (const int steps : {20, 200}) {
            CAPTURE(from_vertical, steps);
            const double slope = pi / 2 - from_vertical, chord = D * std::cos(from_vertical);
            RigidBody block = body_of(Box{{0.2, 0.1, 0.2}}, {0, 0.05, 0}, {0, 0});
            World world = solved({fixed(Plane{}, {0, 0}), block}, gravity_on_slope(slope));
            run(world, steps, T / steps);
            CHECK_THAT(world.bodies[1].state.position.x(), IsClose(chord, Order(1e-9)));
        }
}
