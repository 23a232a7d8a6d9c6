// SPDX-License-Identifier: MIT
// A ball between a wall and a ball 100ⁿ times as heavy that comes towards it: the number of all
// impacts has the first n + 1 digits of π: 3, 31, 314 (Galperin 2003, "Playing pool with π", Regul.
// Chaotic Dyn. 8). In the plane of √M x and √m y each impact is a reflection.
#include "classics/problems.hpp"
#include "support/close.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: two balls and a wall count the digits of pi", "[classics][unsanitized]")
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

namespace {

struct Outcome {
    int bounces = 0;
    double v = 0, V = -1; // the velocities of the light ball and of the heavy one [m/s]
};

// One bounce after the other: off each other if they approach, then off the wall.
Outcome outcome(double ratio)
{
    Outcome out;
    for (;;) {
        if (out.v > out.V) {
            const double v = ((1 - ratio) * out.v + 2 * ratio * out.V) / (1 + ratio);
            out.V = ((ratio - 1) * out.V + 2 * out.v) / (1 + ratio);
            out.v = v;
        } else if (out.v < 0) {
            out.v = -out.v;
        } else {
            return out;
        }
        ++out.bounces;
    }
}

} // namespace

TEST_CASE("classics: the balls of pi bounce hundreds of times in a step", "[classics]")
{
    REQUIRE(outcome(1).bounces == 3);
    REQUIRE(outcome(1e4).bounces == 314);
    const Material elastic{1, 0};
    for (const double ratio : {1.0, 4.0, 16.0, 1e2, 1e3, 1e4})
        for (const double h : {0.02, 0.01, 1.0 / 120, 0.0025}) {
            CAPTURE(ratio, h);
            const RigidBody wall = fixed(Box{{1, 4, 4}}, elastic, {-0.5, 0, 0});
            RigidBody light = ball_of_mass(0.1, 1, {1, 0, 0}, elastic),
                      heavy = ball_of_mass(0.1, ratio, {2, 0, 0}, elastic);
            heavy.state.velocity = {-1, 0, 0};
            World world = solved({wall, light, heavy}, Vector3d::Zero());
            run_until(world, 40, h); // the last bounce is the slowest
            const Outcome out = outcome(ratio);
            const Tolerance tolerance = Rounding(4 * out.bounces, std::sqrt(ratio));
            CHECK_THAT(world.bodies[1].state.velocity.x(), IsClose(out.v, tolerance));
            CHECK_THAT(world.bodies[2].state.velocity.x(), IsClose(out.V, tolerance));
        }
}
