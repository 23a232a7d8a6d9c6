// SPDX-License-Identifier: MIT
// Bodies that fall in a medium: with the drag c V the speed nears M g/c as 1 - e^(-c t/M) (Stokes
// 1851), with k V² it nears √(M g/k) as tanh (Newton 1687, "Principia", book II), and spin dies as
// e^(-d t/I).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: what falls in a medium nears its last speed", "[classics]")
{
    const double M = 12, T = 1.5, c = 20, k = 5, d = 8;
    std::vector<double> slow, fast, spins;
    for (const int steps : {15, 30, 60}) {
        World world = solved({free_box(), free_box()});
        world.bodies[0].drag = {c, 0, 0};
        world.bodies[1].drag = {0, k, d};
        spin(world.bodies[1], {0, 0, 2});
        run(world, steps, T / steps);
        const double rate = std::sqrt(g * k / M);
        slow.push_back(
            std::abs(world.bodies[0].state.velocity.y() + M * g / c * (1 - std::exp(-c * T / M))));
        fast.push_back(std::abs(world.bodies[1].state.velocity.y() +
                                std::sqrt(M * g / k) * std::tanh(rate * T)));
        spins.push_back(std::abs(angular_velocity(world.bodies[1]).z() -
                                 2 * std::exp(-d * T / free_moments.z())));
    }
    CAPTURE(slow, fast, spins);
    for (const std::vector<double>& errors : {slow, fast, spins}) {
        check_at_most(errors.back(), 1e-5, "error");
        CHECK(errors[2] < errors[0] / 16);
    }
}
