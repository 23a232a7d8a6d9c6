// SPDX-License-Identifier: MIT
// What is thrown flies along a parabola (Galilei 1638, "Discorsi"): it reaches v² sin² α/(2 g), and
// lands at v² sin 2α/g, farthest at 45°. A step of any length is exact.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a shot rises and lands where the parabola says", "[classics]")
{
    const double v = 12;
    double farthest = 0, best = 0;
    for (const double degrees : {15., 30., 45., 60., 75.}) {
        const double a = degrees * pi / 180, T = 2 * v * std::sin(a) / g;
        for (const int steps : {2, 10, 200}) {
            CAPTURE(degrees, steps);
            World world = solved({free_box({1, 2, 3})});
            world.bodies[0].state.velocity = {v * std::cos(a), v * std::sin(a), 0};
            run(world, steps / 2, T / steps);
            CHECK_THAT(world.bodies[0].state.position.y(),
                       IsClose(std::pow(v * std::sin(a), 2) / (2 * g), Rounding(8. * steps, 10)));
            run(world, steps / 2, T / steps);
            const Vector3d X(v * v * std::sin(2 * a) / g, 0, 0);
            CHECK_THAT(world.bodies[0].state.position, IsClose(X, Rounding(8. * steps, 20)));
        }
        if (const double x = v * v * std::sin(2 * a) / g; x > farthest) {
            farthest = x;
            best = degrees;
        }
    }
    CHECK(best == 45);
}
