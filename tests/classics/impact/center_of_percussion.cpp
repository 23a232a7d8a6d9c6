// SPDX-License-Identifier: MIT
// A rod that is struck at the distance I/(M s) beyond its center does not move at first at the
// distance s on the other side: there a hand feels no sting (Huygens 1673; the center of
// percussion of a rod held at its end is at two thirds of its length).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a bat that is struck at its sweet spot does not sting the hand", "[classics]")
{
    const Material elastic{1, 0};
    const Vector3d size(0.1, 2, 0.1);
    for (const double s : {0.4, 0.7, 1.}) {
        RigidBody rod = body_of(Box{size}, {0, 0, 0}, elastic);
        const double b = rod.inertia(2, 2) / (rod.mass * s); // where it is struck
        for (const double mass : {0.2, 5., 300.}) {
            CAPTURE(s, mass);
            RigidBody ball = ball_of_mass(0.05, mass, {-0.5, b, 0}, elastic);
            ball.state.velocity = {3, 0, 0};
            World world = solved({rod, ball}, {0, 0, 0});
            run(world, 50, 0.01);
            const RigidBody& hit = world.bodies[0];
            const double w = angular_velocity(hit).z();
            // j = 2 v/(1/m + 1/M + b²/I)
            const double j = 6 / (1 / mass + 1 / rod.mass + b * b / rod.inertia(2, 2));
            CHECK_THAT(hit.state.velocity.x(), IsClose(j / rod.mass, Rounding(1e5)));
            CHECK_THAT(hit.state.velocity.x() + s * w, IsClose(0.0, Rounding(1e5, 1)));
        }
    }
}
