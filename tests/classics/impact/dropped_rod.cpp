// SPDX-License-Identifier: MIT
// A rod without spin falls at the speed v and hits a smooth floor with its tip. The tip is at
// r = L/2 (cos α, -sin α) from the center, where α is the angle between the rod and the floor. It
// gets the impulse j = (1 + ε) v/(1/M + (L/2)² cos² α/I), which turns the rod. Afterwards, the
// upward velocity of the center is -v + j/M (Whittaker, "Analytical dynamics", § 96).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a rod that falls on its tip is turned", "[classics]")
{
    const double L = 1, foot = 0.02, v = 1;
    for (const double e : {0., 0.5, 1.})
        for (const double degrees : {20., 45., 70.}) {
            CAPTURE(e, degrees);
            const double a = degrees * pi / 180;
            const double height = L / 2 * std::sin(a) + foot;
            RigidBody rod = body_of(Capsule{foot, L}, {0, height + 0.0213, 0}, {e, 0},
                                    turn({0, 0, 1}, pi / 2 + a));
            rod.state.velocity = {0, -v, 0};
            World world = solved({fixed(Plane{}, {e, 0}), rod}, {0, 0, 0});
            run(world, 4, 0.01);
            const double I = rod.inertia(0, 0), arm = L / 2 * std::cos(a);
            const double j = (1 + e) * v / (1 / rod.mass + arm * arm / I);
            CHECK_THAT(world.bodies[1].state.velocity.y(),
                       IsClose(j / rod.mass - v, Rounding(1e4, 1)));
            CHECK_THAT(std::abs(angular_velocity(world.bodies[1]).z()),
                       IsClose(arm * j / I, Rounding(1e4, 1)));
        }
}
