// SPDX-License-Identifier: MIT
// A ball between a wall and a ball 100ⁿ times as heavy that comes towards it: the number of all
// impacts has the first n + 1 digits of π: 3, 31, 314 (Galperin 2003, "Playing pool with π", Regul.
// Chaotic Dyn. 8). In the plane of √M x and √m y each impact is a reflection.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: two balls and a wall count the digits of pi", "[classics]")
{
    const Material elastic{1, 0};
    for (const int n : {0, 1, 2}) {
        const double M = std::pow(100., n), R = 0.1;
        World world = solved({fixed(Box{{1, 4, 4}}, elastic, {-0.5 - R, 0, 0}),
                              ball_of_mass(R, 1, {1, 0, 0}, elastic),
                              ball_of_mass(R, M, {1.5, 0, 0}, elastic)},
                             {0, 0, 0});
        world.bodies[2].state.velocity = {-1, 0, 0};
        int impacts = 0;
        const double h = 1e-5 * std::pow(10., 2 - n);
        for (int i = 0; i * h < 3.5 && impacts < 400; ++i) {
            double v1 = world.bodies[1].state.velocity.x();
            step(world, h);
            impacts += world.bodies[1].state.velocity.x() != v1;
        }
        CAPTURE(n);
        const int digits = static_cast<int>(pi * std::pow(10., n));
        // Two of the last impacts may fall into one step.
        CHECK(std::abs(impacts - digits) <= (n < 2 ? 0 : 1));
        // After j impacts of the balls the angle of the motion is j times 2 arctan √(m/M).
        const double a = std::atan(std::sqrt(1 / M)), angle = (digits + 1) / 2 * 2 * a;
        CHECK_THAT(world.bodies[2].state.velocity.x(), IsClose(-std::cos(angle), Order(1e-6)));
    }
}
