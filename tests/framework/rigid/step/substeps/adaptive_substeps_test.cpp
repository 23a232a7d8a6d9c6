// SPDX-License-Identifier: MIT
// Steps for which one normal for each contact is not enough.
#include "framework/rigid/worlds.hpp"
#include "rigid/step/step.hpp"
#include "support/shapes/depth.hpp"

namespace adaptive_substeps_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 1.0 / 60; // [s]
const Material plastic{0, 0.5};

// The depth of body 1 in body 0 [m].
double overlap(const World& world)
{
    const auto pose = [&](int i) { return pose_of(world.bodies[i].state); };
    return overlap_depth(world.bodies[0].parts[0].shape, pose(0), world.bodies[1].parts[0].shape,
                         pose(1));
}

} // namespace

TEST_CASE("adaptive substeps: a corner that hits a wall turns the cube, but not into the wall",
          "[rigid]")
{
    for (const auto method : {ContactMethod::built_in, ContactMethod::simultaneous}) {
        RigidBody cube = body_of(Box{{0.1, 0.1, 0.1}}, {-0.9, 0, 0}, plastic, turn({1, 2, 3}, 0.5));
        cube.state.velocity = {100, 0, 0};
        World world =
            world_of({fixed(Box{{0.01, 10, 10}}, plastic, {0.005, 0, 0}), cube}, {0, 0, 0});
        world.settings.contact_method = method;
        double energy = totals(world).kinetic_energy;
        for (int i = 0; i < 5; ++i) {
            const Vector3d before = totals(world).momentum;
            Vector3d impulse(0, 0, 0);
            for (const ContactRecord& c : step(world, h)) {
                REQUIRE((c.body1 == 0 && c.body2 == 1)); // indices of the whole world
                impulse -= c.impulse;
            }
            const Totals now = totals(world);
            CHECK(overlap(world) <= 0.01 * 0.1); // 1 % of the cube's edge
            CHECK_THAT(now.momentum - before, IsClose(impulse, Rounding(1024, before.norm())));
            CHECK(now.kinetic_energy <= energy * (1 + 1e-12)); // up to rounding
            energy = now.kinetic_energy;
        }
        CHECK(world.counters.steps == 5);
        CHECK(world.time == Approx(5 * h).epsilon(1e-14));
    }
}

TEST_CASE("adaptive substeps: thin plates that slap on each other keep their order", "[rigid]")
{
    std::vector<RigidBody> bodies = {fixed(Plane{}, plastic)};
    for (int i = 0; i < 3; ++i)
        bodies.push_back(body_of(Box{{1, 1e-3, 1}}, {0.05 * i, 0.1 * (i + 1), 0}, plastic,
                                 turn({1, 0, 2}, 0.02 * i)));
    World world = world_of(bodies);
    world.settings.contact_method = ContactMethod::simultaneous;
    run(world, 60, h);
    double below = -5e-4;
    for (int i = 1; i <= 3; ++i) {
        const double y = world.bodies[i].state.position.y();
        CHECK(y - below >= 0.9e-3); // within a tenth of the thickness
        below = y;
    }
}

} // namespace adaptive_substeps_test
