// SPDX-License-Identifier: MIT
// A row of blocks that is pushed from behind on a smooth floor: all have F/Σ M, and each contact
// bears what the blocks in front of it need (Newton's second and third law).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: each block of a row passes on what those before it need", "[classics]")
{
    const std::vector<double> masses = {1, 4, 2, 10};
    const double F = 34, a = F / 17, h = 0.01;
    std::vector<RigidBody> bodies = {fixed(Plane{}, {0, 0})};
    for (int i = 0; i < 4; ++i) {
        RigidBody block = body_of(Box{{0.5, 0.5, 0.5}}, {0.5 * i, 0.25, 0}, {0, 0});
        set_mass(block, masses[i], block.inertia * (masses[i] / block.mass));
        bodies.push_back(block);
    }
    World world = solved(bodies);
    AppliedForce push;
    push.body = 1;
    push.force = {F, 0, 0};
    world.forces = {push};
    for (int n = 1; n <= 60; ++n) {
        std::vector<double> passed(3, 0);
        for (const ContactRecord& contact : step(world, h)) {
            const int first = std::min(contact.body1, contact.body2);
            if (first > 0) passed[first - 1] += std::abs(contact.impulse.x());
        }
        if (n < 10) continue;
        for (int i = 0; i < 3; ++i) {
            double before = 0;
            for (int j = i + 1; j < 4; ++j)
                before += masses[j];
            REQUIRE_THAT(passed[i] / h, IsClose(before * a, Order(1e-4 * F)));
        }
    }
    for (int i = 1; i <= 4; ++i)
        CHECK_THAT(world.bodies[i].state.velocity.x(), IsClose(a * 0.6, Order(1e-6)));
}
