// SPDX-License-Identifier: MIT
// A ball that is dropped bounces to ε² of its height, comes to rest after √(2 H/g) (1 + ε)/(1 - ε)
// and has then gone the way H (1 + ε²)/(1 - ε²) (Newton 1687, "Principia", on restitution).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: each bounce is lower by the square of the restitution", "[classics]")
{
    const double H = 1, R = 0.1;
    for (const double e : {0.9, 0.7, 0.4})
        for (const double h : {0.01, 0.001}) {
            CAPTURE(e, h);
            World world =
                solved({fixed(Plane{}, {e, 0}), body_of(Sphere{R}, {0, H + R, 0}, {e, 0})});
            const double falls = std::sqrt(2 * H / g);
            for (int k = 1; k <= 3; ++k) { // the top of bounce k
                double t = falls;
                for (int i = 1; i <= k; ++i)
                    t += (i < k ? 2 : 1) * falls * std::pow(e, i);
                const double here = world.time;
                run(world, 1, std::fmod(t - here, h));
                run_until(world, t - world.time, h);
                CHECK_THAT(world.bodies[1].state.position.y() - R,
                           IsClose(H * std::pow(e, 2 * k), Rounding(1e4, H)));
            }
            const double rests = falls * (1 + e) / (1 - e);
            run_until(world, std::max(0.0, rests + 0.1 - world.time), h);
            CHECK_THAT(world.bodies[1].state.velocity.y(), IsClose(0.0, Order(g * h)));
        }
}
