// SPDX-License-Identifier: MIT
// A pendulum stands upside down if its pivot is shaken hard enough: a² Ω² > 2 g l (Kapitza 1951;
// Landau and Lifshitz, "Mechanics", § 30), up to terms of a/l.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a pendulum stands on a pivot that is shaken hard enough",
          "[classics][unsanitized]")
{
    const double M = 12, l = 1, a = 0.04, critical = std::sqrt(2 * g * l) / a;
    const double rod = 4e6 * M; // [N/m]
    for (const double share : {0.85, 1.15}) {
        CAPTURE(share);
        const double W = share * critical;
        const double phase = pi / 2; // at the highest point at first
        World world =
            solved({driven(Sphere{0.01}, {}, {0, a, 0}, shaking({0, a, 0}, W / (2 * pi), phase)),
                    free_box()});
        world.bodies[1].state.position = {l * std::sin(0.01), a + l * std::cos(0.01), 0};
        world.springs = {{0, 1, {0, 0, 0}, {0, 0, 0}, rod, 0, l}};
        double tilt = 0;
        for (int i = 0; i < 4000; ++i) {
            step(world, 0.001);
            const Vector3d d = world.bodies[1].state.position - world.bodies[0].state.position;
            tilt = std::max(tilt, std::atan2(std::abs(d.x()), d.y()));
        }
        if (share > 1)
            check_at_most(tilt, 0.1, "tilt [rad]");
        else
            check_at_least(tilt, 1, "tilt [rad]");
    }
}
