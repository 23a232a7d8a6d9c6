// SPDX-License-Identifier: MIT
// Two equal oscillators with a weak spring between them hand their energy to and fro (Huygens'
// sympathy of clocks; Sommerfeld, "Mechanics", § 20): x₁ ± x₂ swing with ω and √(ω² + 2 c/M).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: coupled oscillators hand their swing to and fro", "[classics]")
{
    const double M = 12, k = 400, c = 30, A = 0.2;
    const double w1 = std::sqrt(k / M), w2 = std::sqrt((k + 2 * c) / M);
    const double T = pi / (w2 - w1); // when all is handed over
    std::vector<double> errors;
    for (const int steps : {400, 800, 1600}) {
        World world = solved({free_box(), free_box()}, {0, 0, 0});
        world.bodies[0].state.position = {1 + A, 0, 0};
        world.bodies[1].state.position = {2, 0, 0};
        world.springs = {{-1, 0, {0, 0, 0}, {0, 0, 0}, k, 0, 1},
                         {0, 1, {0, 0, 0}, {0, 0, 0}, c, 0, 1},
                         {1, -1, {0, 0, 0}, {3, 0, 0}, k, 0, 1}};
        run(world, steps, T / steps);
        const double sum = A * std::cos(w1 * T), difference = A * std::cos(w2 * T);
        errors.push_back(std::abs(world.bodies[0].state.position.x() - 1 - (sum + difference) / 2) +
                         std::abs(world.bodies[1].state.position.x() - 2 - (sum - difference) / 2));
        const double energy = M * world.bodies[1].state.velocity.squaredNorm() / 2 +
                              k * std::pow(world.bodies[1].state.position.x() - 2, 2) / 2;
        check_at_least(energy / (k * A * A / 2), 0.9, "share of the energy handed over");
    }
    CAPTURE(errors);
    check_order(errors, 4);
}
