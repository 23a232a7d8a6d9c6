// SPDX-License-Identifier: MIT
// A flat ellipsoid rocks on a rough table with ω² = M g (ρ - b)/(I + M b²): b is its half height,
// and ρ = a²/b the radius of curvature below it. An upright one, with a < b, falls over (the egg of
// Columbus; Lamb 1914, "Dynamics").
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a flat pebble rocks and an upright egg falls", "[classics]")
{
    const double b = 0.2, angle = 1e-3;
    for (const double a : {0.15, 0.3, 0.5}) {
        CAPTURE(a);
        const Material rough{0, 100};
        RigidBody pebble = body_of(Ellipsoid{{a, b, a}}, {0, 0, 0}, rough, turn({0, 0, 1}, angle));
        pebble.state.position.y() = std::hypot(b * std::cos(angle), a * std::sin(angle));
        World world = solved({fixed(Plane{}, rough), pebble});
        if (a < b) {
            run_until(world, 3, 0.005);
            check_at_least(std::abs(world.bodies[1].state.orientation.v.z()), 0.1, "tilt");
            continue;
        }
        const double I = pebble.inertia(2, 2) + pebble.mass * b * b;
        const double w = std::sqrt(pebble.mass * g * (a * a / b - b) / I);
        const double T = 2.25 * 2 * pi / w; // it passes the middle
        run(world, 1000, T / 1000);
        const RigidBody& body = world.bodies[1];
        CHECK_THAT(2 * body.state.orientation.v.z() / angle, IsClose(0.0, Order(0.02)));
        CHECK_THAT(angular_velocity(body).z() / (w * angle), IsClose(-1.0, Order(0.02)));
    }
}
