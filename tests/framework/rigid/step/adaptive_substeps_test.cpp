// SPDX-License-Identifier: MIT
// Steps for which one normal for each contact is not enough.
#include "framework/rigid/worlds.hpp"
#include "rigid/step/step.hpp"
#include "support/depth.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 1.0 / 60;
const Material plastic{0, 0.5}, smooth{0, 0};

// The depth of body 1 in body 0 [m].
double overlap(const World& world)
{
    const auto pose = [&](int i) { return pose_of(world.bodies[i].state); };
    return overlap_depth(world.bodies[0].parts[0].shape, pose(0), world.bodies[1].parts[0].shape,
                         pose(1));
}

// Two boxes that meet at x = 0, whose tops both lie at y = 0.
World joint(const RigidBody& body)
{
    const Box tile{{10, 1, 10}};
    return world_of({fixed(tile, smooth, {-5, -0.5, 0}), fixed(tile, smooth, {5, -0.5, 0}), body});
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
            CHECK(overlap(world) <= 0.01 * 0.1); // 0.005 is tolerated; class I
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
        CHECK(y - below >= 0.9e-3); // within a tenth of the thickness; class I
        below = y;
    }
}

TEST_CASE("a box that slides over a joint does not run into it, however slowly", "[rigid]")
{
    for (const double speed : {0.01, 0.1, 1.0, 10.0})
        for (const double angle : {0.0, 0.3})
            for (const bool is_ball : {false, true}) {
                const Shape shape = is_ball ? Shape(Sphere{0.5}) : Shape(Box{{1, 1, 1}});
                RigidBody body = body_of(shape, {-0.5 - 10.5 * speed * h, 0.5, 0}, smooth,
                                         turn({0, 1, 0}, angle));
                body.state.velocity = {speed, 0, 0};
                World world = joint(body);
                run(world, 30, h);
                CAPTURE(speed, angle, is_ball);
                CHECK_THAT(world.bodies[2].state.velocity,
                           IsClose(Vector3d(speed, 0, 0), Rounding(64 * 30, 10)));
            }
}

TEST_CASE("a box that lands at a joint keeps its speed along it", "[rigid]")
{
    for (int i = 0; i < 20; ++i) {
        const double x = -0.5 - 0.1 + 0.01 * i; // its center; the front edge is around the joint
        RigidBody box = body_of(Box{{1, 1, 1}}, {x, 0.51, 0}, smooth);
        box.state.velocity = {3, -1, 0};
        World world = joint(box);
        run(world, 5, h);
        CAPTURE(x);
        // The corners do not land at the same time, and the tilt that this causes is of class I.
        CHECK(std::abs(world.bodies[2].state.velocity.x() - 3) <= 0.01);
    }
}

TEST_CASE("a box that flies at the side of another is stopped by it", "[rigid]")
{
    RigidBody box = body_of(Box{{1, 1, 1}}, {-1, 0.5, 0}, smooth);
    box.state.velocity = {3, 0, 0};
    World world = world_of({fixed(Box{{1, 1, 1}}, smooth, {0.6, 0.5, 0}), box}, {0, 0, 0});
    run(world, 30, h);
    CHECK_THAT(world.bodies[1].state.velocity.x(), IsClose(0.0, Rounding(1024, 3)));
}
