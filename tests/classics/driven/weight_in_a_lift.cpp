// SPDX-License-Identifier: MIT
// In a lift a body weighs M (g + a), a the acceleration of the lift (d'Alembert 1743): what a scale
// shows while the lift swings up and down.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a scale in a lift shows gravity and acceleration", "[classics]")
{
    const double f = 0.7, w = 2 * pi * f, A = 0.3 * g / (w * w), h = 0.005;
    RigidBody body = body_of(Box{{0.4, 0.3, 0.4}}, {0, 0.15, 0}, {0, 0.5});
    body.state.velocity = {0, A * w, 0};
    World world =
        solved({driven(Box{{2, 1, 2}}, {0, 0.5}, {0, -0.5, 0}, shaking({0, A, 0}, f)), body});
    double largest = 0;
    for (int n = 0; n < 400; ++n) {
        double weight = 0;
        for (const ContactRecord& contact : step(world, h))
            weight += std::abs(contact.impulse.y()) / h;
        const double a = -A * w * w * std::sin(w * h * (n + 0.5));
        if (n > 3) largest = std::max(largest, std::abs(weight / body.mass - g - a));
    }
    check_at_most(largest, 0.5 * A * w * w * w * h, "error of the weight [N/kg]");
}
