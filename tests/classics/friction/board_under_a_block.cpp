// SPDX-License-Identifier: MIT
// A board on a smooth floor is pulled from under a block (Irodov, "Problems in general physics",
// 1.73): up to F = μ g (M + m) both go together with F/(M + m); beyond it the block follows with
// μ g only and the board runs ahead with (F - μ m g)/M.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a board that is pulled hard leaves its block behind", "[classics]")
{
    const double m = 3, M = 5, mu = 0.3, T = 0.5, critical = mu * g * (M + m);
    for (const double share : {0.5, 0.99, 1.01, 2.})
        for (const double h : {0.01, 0.0025}) {
            CAPTURE(share, h);
            RigidBody board = body_of(Box{{4, 0.1, 1}}, {0, 0.05, 0}, {0, mu});
            RigidBody block = body_of(Box{{0.4, 0.04, 0.4}}, {0, 0.12, 0}, {0, mu});
            set_mass(board, M, board.inertia * (M / board.mass));
            set_mass(block, m, block.inertia * (m / block.mass));
            World world = solved({fixed(Plane{}, {0, 0}), board, block});
            AppliedForce pull;
            pull.body = 1;
            pull.force = {share * critical, 0, 0};
            world.forces = {pull};
            run_until(world, T, h);
            const double F = share * critical;
            const double a1 = share < 1 ? F / (M + m) : (F - mu * m * g) / M;
            const double a2 = share < 1 ? a1 : mu * g;
            CHECK_THAT(world.bodies[1].state.velocity.x(), IsClose(a1 * T, Order(1e-5)));
            CHECK_THAT(world.bodies[2].state.velocity.x(), IsClose(a2 * T, Order(1e-5)));
            CHECK_THAT(world.bodies[2].state.position.x(), IsClose(a2 * T * T / 2, Order(1e-4)));
        }
}
