// SPDX-License-Identifier: MIT
// At resonance the amplitude grows evenly (Landau and Lifshitz, "Mechanics", § 22):
// x = F/(2 M ω²) (sin ω t - ω t cos ω t) from rest, under F sin ω t.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a force at resonance makes the amplitude grow evenly", "[classics]")
{
    const double M = 12, f = 1, w = 2 * pi * f, F = 20;
    for (const double T : {3.1, 10.3}) {
        std::vector<double> errors;
        for (const int steps : {200, 400, 800}) {
            World world = solved({free_box()}, {0, 0, 0});
            world.bodies[0].state.position = {5, 0, 0};
            world.springs = {{-1, 0, {0, 0, 0}, {0, 0, 0}, M * w * w, 0, 5}};
            AppliedForce force;
            force.force = {F, 0, 0};
            force.frequency = f;
            world.forces = {force};
            run(world, steps, T / steps);
            const double x = F / (2 * M * w * w) * (std::sin(w * T) - w * T * std::cos(w * T));
            errors.push_back(std::abs(world.bodies[0].state.position.x() - 5 - x));
        }
        CAPTURE(T, errors);
        check_order(errors, 4);
    }
}
