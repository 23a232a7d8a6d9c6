// SPDX-License-Identifier: MIT
#include "framework/rigid/worlds.hpp"
#include "rigid/contact/position_correction.hpp"
#include "rigid/step/step.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("position correction: overlap heals without a jump", "[rigid]")
{
    for (const double part : {0.01, 0.1, 0.5}) {
        CAPTURE(part);
        World world = world_of(
            {fixed(Plane{}, {0.5, 0.5}), body_of(Box{{0.3, 0.3, 0.3}}, {0, 0.15 - 0.3 * part, 0})});
        double highest = 0;
        for (int i = 0; i < 300; ++i) {
            step(world, 0.01);
            highest = std::max(highest, world.bodies[1].state.position.y());
        }
        CHECK(highest < 0.155);
        CHECK(std::abs(world.bodies[1].state.position.y() - 0.15) < 0.001);
        CHECK(world.bodies[1].state.velocity.norm() < 1e-6);
    }
}
