// SPDX-License-Identifier: MIT
// A tippe top turns upside down while it spins (Pliskin 1954; Or 1994, "The dynamics of a tippe
// top"): a ball whose center of mass is a little below its middle, on a table with friction. Its
// spin about the vertical keeps its direction, so that in the body it changes sign.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a tippe top turns upside down", "[classics]")
{
    const double R = 0.02, M = 0.01, down = 0.15 * R, mu = 0.3;
    for (const double h : {0.001, 0.0005}) {
        CAPTURE(h);
        RigidBody top = body_of(Sphere{R}, {0, 0, 0}, {0, mu}, turn({0, 0, 1}, 0.1));
        top.parts[0].position = {0, down, 0};
        set_mass(top, M, 0.4 * M * R * R * Matrix3d::Identity());
        top.state.position = {0, R - down * std::cos(0.1), 0};
        spin(top, {0, 300, 0});
        World world = solved({fixed(Plane{}, {0, mu}), top});
        double lowest = 1;
        for (int i = 0; i * h < 5 && lowest > -0.95; ++i) {
            step(world, h);
            lowest = std::min(lowest, rotation_matrix(world.bodies[1].state.orientation)(1, 1));
        }
        check_at_most(lowest, -0.9, "cosine of the tilt");
        check_at_least(angular_velocity(world.bodies[1]).y(), 10, "spin [rad/s]");
    }
}
