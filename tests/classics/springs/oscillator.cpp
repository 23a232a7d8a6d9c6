// SPDX-License-Identifier: MIT
// A body on a spring swings with √(k/M), whatever the amplitude (Hooke 1678, "De potentia
// restitutiva").
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

// x(t) = A cos ω t about the rest length.
TEST_CASE("classics: a body on a spring swings as fast however far", "[classics]")
{
    const double k = 300, M = 12, w = std::sqrt(k / M), T = 2.5;
    for (const double A : {0.001, 0.1, 0.9}) {
        std::vector<double> errors;
        for (const int steps : {40, 80, 160}) {
            World world = solved({free_box()}, {0, 0, 0});
            world.bodies[0].state.position = {1 + A, 0, 0};
            world.springs = {{-1, 0, {0, 0, 0}, {0, 0, 0}, k, 0, 1}};
            run(world, steps, T / steps);
            const double x = world.bodies[0].state.position.x() - 1;
            errors.push_back(std::abs(x - A * std::cos(w * T)) / A);
        }
        CAPTURE(A, errors);
        check_order(errors, 4);
        check_at_most(errors.back(), 1e-5, "error in amplitudes");
    }
}
