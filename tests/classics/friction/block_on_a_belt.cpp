// SPDX-License-Identifier: MIT
// A block on a belt, held by a spring (Den Hartog 1934, "Mechanical vibrations"): with friction
// that does not depend on speed it sticks until the spring pulls with μ M g, and then swings for
// ever about μ M g/k with the amplitude u/ω.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a block on a belt and a spring swings by the speed of the belt",
          "[classics][unsanitized]")
{
    const double k = 100, M = 2, mu = 0.3, w = std::sqrt(k / M), middle = mu * M * g / k;
    for (const double u : {0.05, 0.2}) { // less than μ g/ω, so that it sticks at first
        for (const double h : {0.002, 0.0005}) {
            CAPTURE(u, h);
            RigidBody block = body_of(Box{{0.4, 0.02, 0.4}}, {0, 0.01, 0}, {0, mu});
            set_mass(block, M, block.inertia * (M / block.mass));
            Drive belt = moving({u, 0, 0});
            belt.is_belt = true;
            World world = solved({driven(Box{{20, 1, 20}}, {0, mu}, {0, -0.5, 0}, belt), block});
            world.springs = {{-1, 1, {-2, 0.01, 0}, {0, 0, 0}, k, 0, 2}};
            run_until(world, middle / u * 0.8, h); // it still sticks
            CHECK_THAT(world.bodies[1].state.velocity.x(), IsClose(u, Order(1e-6)));
            run_until(world, middle / u * 0.2 + 3, h);
            double least = 1e9, most = -1e9;
            for (int i = 0; i * h < 2 * pi / w; ++i) {
                step(world, h);
                least = std::min(least, world.bodies[1].state.position.x());
                most = std::max(most, world.bodies[1].state.position.x());
            }
            CHECK_THAT((most + least) / 2, IsClose(middle, Order(0.01 * middle)));
            CHECK_THAT((most - least) / 2, IsClose(u / w, Order(0.05 * u / w)));
        }
    }
}
