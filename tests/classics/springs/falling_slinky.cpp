// SPDX-License-Identifier: MIT
// A hanging chain of springs that is let go: its center of mass falls freely, but its lower end
// stays where it is until the wave from above arrives (Calkin 1993, "Motion of a falling spring",
// Am. J. Phys. 61). The wave passes √(k/M) links a second: n masses take n √(M/k).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: the lower end of a falling spring waits for the upper one", "[classics]")
{
    constexpr int N = 40;
    const double M = 12, k = 24000;
    World world = solved(std::vector<RigidBody>(N, free_box()));
    double y = 0, center = 0;
    for (int i = 0; i < N; ++i) { // from the upper end down; link i carries what is below it
        world.bodies[i].state.position = {0, y, 0};
        center += y / N;
        if (i + 1 < N) world.springs.push_back({i, i + 1, {0, 0, 0}, {0, 0, 0}, k, 0, 0});
        y -= M * g * (N - 1 - i) / k;
    }
    const double bottom = world.bodies.back().state.position.y();
    const double wave = N * std::sqrt(M / k);
    constexpr int steps = 400;
    for (int n = 1; n <= steps; ++n) {
        const double t = 0.7 * wave * n / steps;
        step(world, 0.7 * wave / steps);
        double mean = 0;
        for (const RigidBody& body : world.bodies)
            mean += body.state.position.y() / N;
        REQUIRE_THAT(mean, IsClose(center - g * t * t / 2, Rounding(100. * n, 10)));
        REQUIRE_THAT(world.bodies.back().state.position.y(),
                     IsClose(bottom, Order(1e-4 * g * t * t / 2 + 1e-9)));
    }
    check_at_most(world.bodies.front().state.position.y(), -0.5, "place of the upper end [m]");
}
