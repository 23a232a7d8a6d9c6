// SPDX-License-Identifier: MIT
// A block on a spring on a rough table (Coulomb 1785; Lorenz 1924): each half swing is shorter by
// 2 μ M g/k than the last one, and takes as long as without friction. It stops where the spring
// pulls less than friction holds.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: friction shortens each swing by the same", "[classics]")
{
    const double k = 200, M = 2, w = std::sqrt(k / M), A = 0.5;
    for (const double mu : {0.05, 0.2}) {
        const double lost = 2 * mu * M * g / k, half = pi / w;
        std::vector<double> errors;
        for (const int steps : {100, 200, 400}) { // steps in half a swing
            RigidBody block = body_of(Box{{0.4, 0.05, 0.4}}, {A, 0.025, 0}, {0, mu});
            set_mass(block, M, block.inertia * (M / block.mass));
            World world = solved({fixed(Plane{}, {0, mu}), block});
            world.springs = {{-1, 1, {-2, 0.025, 0}, {0, 0, 0}, k, 0, 2}};
            double off = 0, place = A;
            for (int n = 0; n < 4; ++n) {
                run(world, steps, half / steps);
                place = place > 0 ? -(place - lost) : -(place + lost);
                off = std::max(off, std::abs(world.bodies[1].state.position.x() - place));
            }
            errors.push_back(off);
        }
        CAPTURE(mu, errors);
        // Apart from the steps in which the motion turns, the integrator makes hardly any error.
        check_at_most(errors.back(), 1e-9 * A, "error of the turning points [m]");
    }
}
