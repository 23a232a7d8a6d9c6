// SPDX-License-Identifier: MIT
// A stick that falls over on a rough floor turns about its foot: ω² = 3 g/L (1 - cos θ), so its
// tip arrives with √(3 g L), faster than a stone from the same height (the falling chimney; Routh).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: the tip of a falling stick is faster than a stone", "[classics]")
{
    const double L = 1, foot = 0.01;
    const Material rough{0, 1e5}; // at 70 degrees the foot hardly presses, but must not slip
    for (const double h : {0.005, 0.001}) {
        CAPTURE(h);
        const double start = 0.2; // from the vertical [rad]
        RigidBody stick =
            body_of(Box{{2 * foot, L, 0.3}}, {0, 0, 0}, rough, turn({0, 0, 1}, -start));
        const Matrix3d Q = rotation_matrix(stick.state.orientation);
        stick.state.position = -Q * Vector3d(foot, -L / 2, 0); // its right edge at the origin
        World world = solved({fixed(Plane{}, rough), stick});
        const double r = std::hypot(L / 2, foot), I = stick.inertia(2, 2) + stick.mass * r * r;
        const double top = stick.state.position.y();
        while (rotation_matrix(world.bodies[1].state.orientation)(1, 1) > 0.1)
            step(world, h);
        const double y = world.bodies[1].state.position.y();
        const double w = std::sqrt(2 * stick.mass * g * (top - y) / I);
        CHECK_THAT(-angular_velocity(world.bodies[1]).z(), IsClose(w, Order(12 * h)));
        check_at_least(w * L, std::sqrt(2 * g * L), "speed of the tip [m/s]");
    }
}
