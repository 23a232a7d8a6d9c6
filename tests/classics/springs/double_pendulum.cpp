// SPDX-License-Identifier: MIT
// Two equal balls, one below the other on equal ropes, have two modes (Daniel Bernoulli 1733): the
// lower rope swings √2 times as far as the upper one, on its side with ω² = (2 - √2) g/l or on the
// other side with (2 + √2) g/l.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a double pendulum swings in its two modes", "[classics]")
{
    const double M = 12, l = 0.5, k = 1e6, A = 1e-4;
    for (const double side : {1., -1.}) {
        const double w = std::sqrt(g / l * (2 - side * std::sqrt(2.))), T = pi / (2 * w);
        World world = solved({free_box(), free_box()});
        world.bodies[0].state.position = {A, -l, 0};
        world.bodies[1].state.position = {(1 + side * std::sqrt(2.)) * A, -2 * l, 0};
        world.springs = {{-1, 0, {0, 0, 0}, {0, 0, 0}, k, 0, l - 2 * M * g / k},
                         {0, 1, {0, 0, 0}, {0, 0, 0}, k, 0, l - M * g / k}};
        run(world, 400, T / 400);
        CAPTURE(side);
        for (int i = 0; i < 2; ++i) {
            const double share = i == 0 ? 1 : 1 + side * std::sqrt(2.);
            const RigidState& s = world.bodies[i].state;
            CHECK_THAT(s.position.x(), IsClose(0.0, Order(1e-4 * A)));
            CHECK_THAT(s.velocity.x(), IsClose(-share * w * A, Order(1e-4 * w * A)));
        }
    }
}
