// SPDX-License-Identifier: MIT
// If one of the two supports of a beam is taken away, the other bears at once only a quarter of the
// weight: N = M g/(1 + M d²/I), for a thin beam that it holds at its end (Irodov, "Problems in
// general physics"; Sommerfeld).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: the last support of a beam bears a quarter of it", "[classics]")
{
    const double L = 2, H = 0.1;
    const Material smooth{0, 0};
    for (const double d : {0.3, 0.9})
        for (const double h : {0.01, 0.001}) {
            CAPTURE(d, h);
            RigidBody beam = body_of(Box{{L, H, 0.4}}, {0, H / 2, 0}, smooth);
            // The edge of the support is at x = -d.
            World world = solved({fixed(Box{{2, 1, 1}}, smooth, {-d - 1, -0.5, 0}), beam});
            double impulse = 0;
            for (const ContactRecord& contact : step(world, h))
                impulse += std::abs(contact.impulse.y());
            const double N = beam.mass * g / (1 + beam.mass * d * d / beam.inertia(2, 2));
            CHECK_THAT(impulse / h, IsClose(N, Order(1e-5 * N + beam.mass * g * h)));
        }
}
