// SPDX-License-Identifier: MIT
// A stick on two fingers that come together stays in balance: now one slides and now the other, and
// they meet under its center of mass (Gardner; Mach, "The science of mechanics"), wherever they
// began.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: two fingers under a stick meet at its center", "[classics][unsanitized]")
{
    const double mu = 0.4, u = 0.1, R = 0.02;
    const Quaternion lying = turn({1, 0, 0}, pi / 2);
    for (const double left : {0.3, 0.8}) {
        CAPTURE(left);
        const double right = 0.7, h = 0.002;
        World world =
            solved({driven(Cylinder{R, 0.4}, {0, mu}, {-left, -R, 0}, moving({u, 0, 0}), lying),
                    driven(Cylinder{R, 0.4}, {0, mu}, {right, -R, 0}, moving({-u, 0, 0}), lying),
                    body_of(Box{{2, 0.02, 0.1}}, {0, 0.01, 0}, {0, mu})});
        run_until(world, (left + right - 3 * R) / (2 * u), h); // until they nearly touch
        const double middle =
            (world.bodies[0].state.position.x() + world.bodies[1].state.position.x()) / 2;
        const RigidState& s = world.bodies[2].state;
        CHECK_THAT(s.position.x(), IsClose(middle, Order(1.5 * R)));
        CHECK_THAT(s.orientation.v.z(), IsClose(0.0, Order(1e-3)));
    }
}
