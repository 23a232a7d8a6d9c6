// SPDX-License-Identifier: MIT
// A force that fades as e^(-t/τ) gives the impulse F τ (1 - e^(-t/τ)): a factor may be any
// function of the time.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a force that fades gives a finite impulse", "[classics]")
{
    const double F = 30, M = 12, tau = 0.4, T = 2;
    std::vector<double> errors;
    for (const int steps : {20, 40, 80}) {
        World world = solved({free_box()}, {0, 0, 0});
        AppliedForce force;
        force.force = {F, 0, 0};
        force.factor = [](double t) { return std::exp(-t / 0.4); };
        world.forces = {force};
        run(world, steps, T / steps);
        const double V = F * tau / M * (1 - std::exp(-T / tau));
        errors.push_back(std::abs(world.bodies[0].state.velocity.x() - V));
    }
    CAPTURE(errors);
    check_order(errors, 4);
}
