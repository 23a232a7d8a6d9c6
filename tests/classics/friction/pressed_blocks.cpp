// SPDX-License-Identifier: MIT
// A hand presses blocks against a wall so hard that friction holds them: nothing moves, however
// light or heavy the hand is. Each face carries 4 contacts; balance leaves open how they share its
// load, and only an even share holds the block without turning it.
#include "classics/problems.hpp"
#include "support/random.hpp"

namespace pressed_blocks {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double mu = 0.3, thickness = 0.1; // [m]

// A wall whose face is x = 0, blocks beside it, and a hand that pushes along -x and carries itself
// and half of the weight of the blocks.
// @param reserve  how many times the needed force the hand pushes with
World pressed(int blocks, double hand_mass, double reserve, Random& random)
{
    const Material material{0, mu};
    std::vector<RigidBody> bodies = {fixed(Box{{0.1, 0.6, 0.6}}, material, {-0.05, 0, 0})};
    double mass = 0; // all blocks together [kg]
    for (int i = 0; i < blocks; ++i) {
        const double size = random.uniform(0.2, 0.4);
        RigidBody block =
            body_of(Box{{thickness, size, size}}, {(i + 0.5) * thickness, 0, 0}, material);
        const double m = random.uniform(0.5, 2);
        set_mass(block, m, m * block.inertia / block.mass);
        mass += m;
        bodies.push_back(block);
    }
    RigidBody hand = body_of(Box{{0.1, 0.5, 0.5}}, {blocks * thickness + 0.05, 0, 0}, material);
    set_mass(hand, hand_mass, hand_mass * hand.inertia / hand.mass);
    hand.inverse.inverse_inertia.setZero(); // it does not turn
    bodies.push_back(hand);
    World world = solved(bodies);
    AppliedForce push;
    push.body = static_cast<int>(bodies.size()) - 1;
    push.force = {-reserve * mass * g / 2 / mu, (mass / 2 + hand_mass) * g, 0};
    world.forces = {push};
    return world;
}

} // namespace

TEST_CASE("classics: blocks stay where a hand presses them against a wall", "[classics]")
{
    Random random(1);
    for (const int blocks : {1, 2, 3})
        for (const double hand_mass : {0.01, 0.1, 1.0, 5.0})
            for (const double reserve : {1.05, 2.0, 10.0})
                for (const double h : {0.01, 0.002}) {
                    World world = pressed(blocks, hand_mass, reserve, random);
                    const std::vector<RigidBody> before = world.bodies;
                    run_until(world, 0.2, h);
                    CAPTURE(blocks, hand_mass, reserve, h);
                    for (std::size_t i = 0; i < before.size(); ++i)
                        check_at_most(
                            (world.bodies[i].state.position - before[i].state.position).norm(),
                            1e-9, "motion of a body [m]");
                }
}

} // namespace pressed_blocks
