// SPDX-License-Identifier: MIT
// A pendulum whose pivot is shaken up and down with twice its own frequency swings up by itself
// (Landau and Lifshitz, "Mechanics", § 27): small swings that pass the middle as the pivot passes
// its own going up grow with the rate ω a/l.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a swing grows if its pivot is shaken with twice its frequency",
          "[classics][unsanitized]")
{
    const double M = 12, l = 1, w = std::sqrt(g / l), rod = 1e6 * M;
    for (const double a : {0.01, 0.03}) {
        CAPTURE(a);
        World world =
            solved({driven(Sphere{0.01}, {}, {0, 0, 0}, shaking({0, a, 0}, 2 * w / (2 * pi))),
                    free_box()});
        world.bodies[1].state.position = {0, -l, 0};
        world.springs = {{0, 1, {0, 0, 0}, {0, 0, 0}, rod, 0, l - M * g / rod}};
        world.bodies[1].state.velocity = {1e-5, 2 * w * a, 0}; // upwards with the pivot
        const double period = 2 * pi / w;
        const auto swing = [&] { // the largest excursion over a period
            double largest = 0;
            for (int i = 0; i < 500; ++i) {
                step(world, period / 500);
                largest = std::max(largest, std::abs(world.bodies[1].state.position.x()));
            }
            return largest;
        };
        swing();
        const double early = swing();
        for (int n = 0; n < 9; ++n)
            swing();
        const double rate = std::log(swing() / early) / (10 * period);
        CHECK_THAT(rate / (w * a / l), IsClose(1.0, Order(a)));
    }
}
