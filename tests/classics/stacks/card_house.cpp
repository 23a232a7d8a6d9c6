// SPDX-License-Identifier: MIT
// Two equal cards that lean on each other stand if tan β ≤ 2 μ, β their angle with the vertical:
// each foot bears the weight M g of one card, and the tops push each other with M g tan β/2.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: two cards lean on each other on a rough table", "[classics]")
{
    const double L = 1, R = 0.001;
    for (const double degrees : {10., 25., 40.})
        for (const double share : {0.97, 1.03})
            for (const double h : {1 / 60., 1 / 240.}) {
                CAPTURE(degrees, share, h);
                const double b = degrees * pi / 180, mu = share * std::tan(b) / 2;
                std::vector<RigidBody> bodies = {fixed(Plane{}, {0, mu})};
                for (const int side : {-1, 1}) // tops at x = ±R
                    bodies.push_back(
                        body_of(Capsule{R, L},
                                {side * (R + L / 2 * std::sin(b)), R + L / 2 * std::cos(b), 0},
                                {0, mu}, turn({0, 0, 1}, side * b)));
                World world = solved(bodies);
                world.pair_laws = {{1, 2, {}, 1., true}};
                const double y = bodies[1].state.position.y();
                run(world, static_cast<int>(1 / h), h);
                const double falls = y - world.bodies[1].state.position.y();
                if (share > 1)
                    check_at_most(falls, 1e-4, "fall [m]");
                else
                    check_at_least(falls, 0.01, "fall [m]");
            }
}
