// SPDX-License-Identifier: MIT
// A beam that hangs on two ropes turns to and fro about the vertical: ω² = M g d²/(I l) for
// ropes of the length l at the distance d from the middle (Kohlrausch, "Praktische Physik").
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a beam on two ropes turns by its moment of inertia", "[classics]")
{
    const double M = 12, l = 0.8, k = 1e6, angle = 1e-4;
    for (const double d : {0.1, 0.5}) {
        const double w = std::sqrt(M * g * d * d / (free_moments.y() * l)), T = pi / (2 * w);
        World world = solved({free_box()});
        world.bodies[0].state.orientation = turn({0, 1, 0}, angle);
        for (const double side : {-d, d}) {
            Spring rope{-1, 0, {side, l, 0}, {side, 0, 0}, k, 0, l - M * g / (2 * k)};
            rope.only_pulls = true;
            world.springs.push_back(rope);
        }
        run(world, 400, T / 400); // a quarter of the period
        const RigidBody& beam = world.bodies[0];
        CAPTURE(d);
        CHECK_THAT(2 * beam.state.orientation.v.y(), IsClose(0.0, Order(1e-4 * angle)));
        CHECK_THAT(angular_velocity(beam).y(), IsClose(-w * angle, Order(1e-4 * w * angle)));
    }
}
