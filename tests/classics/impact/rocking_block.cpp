// SPDX-License-Identifier: MIT
// A tall block that rocks from edge to edge without bouncing keeps the share 1 - 3/2 sin² α of its
// angular velocity at each impact, tan α = width/height (Housner 1963, "The behavior of inverted
// pendulum structures during earthquakes").
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a rocking block keeps the share of Housner at each impact", "[classics]")
{
    const double H = 2;
    for (const double width : {0.3, 0.5, 1.}) {
        CAPTURE(width);
        const double a = std::atan(width / H), r = std::hypot(width, H) / 2, tilt = 0.4 * a;
        const Material rough{0, 100};
        // On its lower right edge at the origin, tilted to the right.
        const Vector3d X(-r * std::sin(a - tilt), r * std::cos(a - tilt), 0);
        World world = solved(
            {fixed(Plane{}, rough), body_of(Box{{width, H, 1}}, X, rough, turn({0, 0, 1}, -tilt))});
        const double h = 1e-3;
        double before = 0, after = 0;
        for (int i = 0; i * h < 2 && after == 0; ++i) {
            step(world, h);
            const RigidBody& block = world.bodies[1];
            const double w = angular_velocity(block).z();
            if (w > 0) before = std::max(before, w);
            if (before > 0 && std::abs(w) < 0.97 * before) after = w;
        }
        const double share = 1 - 1.5 * std::pow(std::sin(a), 2);
        CHECK_THAT(after / before, IsClose(share, Order(0.01)));
    }
}
