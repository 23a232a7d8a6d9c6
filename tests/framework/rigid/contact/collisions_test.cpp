// SPDX-License-Identifier: MIT
// The collision stage of a step, compared with results computed by hand.
#include "framework/rigid/worlds.hpp"
#include "rigid/step/step.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

const Vector3d no_gravity(0, 0, 0);

Material material(double restitution, double friction)
{
    return {restitution, friction};
}

// A body whose only part is a single point at `tip`.
RigidBody rod(const Vector3d& tip, double restitution)
{
    RigidBody body = body_of(Sphere{1}, {0, 0, 0}, {restitution, 0});
    body.parts[0].shape = Sphere{0};
    body.parts[0].position = tip;
    set_mass(body, 1, Vector3d(1. / 12, 0, 1. / 12).asDiagonal().toDenseMatrix());
    return body;
}

} // namespace

TEST_CASE("collision: the tip of a rod hits a frictionless floor", "[rigid]")
{
    RigidBody body = rod({0, -0.5, 0}, 0.5);
    body.state.orientation = turn({0, 0, 1}, std::numbers::pi / 4);
    body.state.position = {0, std::sqrt(0.125) - 1e-12, 0};
    body.state.velocity = {0, -1, 0};
    World world = world_of({fixed(Plane{}, material(1, 0)), body}, no_gravity);
    const auto contacts = step(world, 1e-3);

    REQUIRE(contacts.size() == 1);
    const RigidBody& after = world.bodies[1];
    // The plane is body 1, so the impulse on it points down.
    CHECK_THAT(contacts[0].impulse, IsClose(Vector3d(0, -0.6, 0), Rounding(32)));
    CHECK_THAT(after.state.velocity, IsClose(Vector3d(0, -0.4, 0), Rounding(32)));
    CHECK_THAT(std::abs(after.state.angular_momentum.z()) * 12,
               IsClose(2.54558441227157, Rounding(64)));
}

TEST_CASE(
    "collision: a ball that hits the floor at an angle sticks from two sevenths of friction on",
    "[rigid]")
{
    const auto after = [](double friction) {
        RigidBody ball = body_of(Sphere{0.1}, {0, 0.1, 0}, material(0.5, friction));
        ball.state.velocity = {3, -2, 0};
        World world = world_of({fixed(Plane{}, material(1, friction)), ball}, no_gravity);
        step(world, 1e-3);
        return world.bodies[1];
    };
    const RigidBody sticks = after(2. / 7 * 1.000001), slides = after(0.1);
    CHECK_THAT(sticks.state.velocity, IsClose(Vector3d(15. / 7, 1, 0), Rounding(32)));
    CHECK_THAT(angular_velocity(sticks), IsClose(Vector3d(0, 0, -150. / 7), Rounding(32)));
    CHECK_THAT(slides.state.velocity, IsClose(Vector3d(2.7, 1, 0), Rounding(32)));
    CHECK_THAT(angular_velocity(slides), IsClose(Vector3d(0, 0, -7.5), Rounding(32)));
    CHECK(after(2. / 7 * 0.999999).state.velocity.x() > 15. / 7); // it still slides
}

TEST_CASE("collision: between two walls every bounce costs the factor of restitution", "[rigid]")
{
    for (const double restitution : {1.0, 0.8, 0.5}) {
        RigidBody ball = body_of(Sphere{0.1}, {0, 0.5, 0}, material(restitution, 0.3));
        ball.state.velocity = {0, -2, 0};
        World world = world_of(
            {fixed(Plane{}, material(1, 0.3)),
             fixed(Plane{}, material(1, 0.3), {0, 1, 0}, turn({0, 0, 1}, std::numbers::pi)), ball},
            no_gravity);
        int bounces = 0;
        double speed = 2;
        for (int i = 0; i < 400; ++i) {
            step(world, 0.01);
            const double now = world.bodies[2].state.velocity.norm();
            if (std::abs(now - speed) > 1e-9 * speed) ++bounces;
            speed = now;
        }
        if (restitution < 1) REQUIRE(bounces >= 3);
        CHECK_THAT(speed, IsClose(2 * std::pow(restitution, bounces), Rounding(64)));
    }
}

TEST_CASE("collision: a ball bounces to the square of its restitution", "[rigid]")
{
    std::vector<double> worst;
    for (const double h : {4e-4, 1e-4}) {
        World world = world_of(
            {fixed(Plane{}, material(1, 0)), body_of(Sphere{0.1}, {0, 1.1, 0}, material(0.8, 0))});
        double error = 0, before = 0, expected = 1;
        bool rises = false;
        for (int i = 0; i < static_cast<int>(3 / h); ++i) {
            step(world, h);
            const RigidState& s = world.bodies[1].state;
            const double height = s.position.y() - 0.1;
            if (rises && s.velocity.y() <= 0)
                error = std::max(error, std::abs(std::max(before, height) - (expected *= 0.64)));
            rises = s.velocity.y() > 0;
            before = height;
        }
        CHECK(expected < 0.1); // at least six bounces
        worst.push_back(error);
    }
    // The engine moves a bounce to its time of impact, so only the highest point is missed: it lies
    // up to half a step from the nearest state, g h²/8 above it.
    CHECK(worst[0] < 9.81 * 4e-4 * 4e-4 / 8 + 1e-9);
    CHECK(worst[1] < 9.81 * 1e-4 * 1e-4 / 8 + 1e-9);
}

TEST_CASE("collision: a perfectly elastic ball keeps its energy for good", "[rigid]")
{
    World world = world_of(
        {fixed(Plane{}, material(1, 0)), body_of(Sphere{0.1}, {0, 1.1, 0}, material(1, 0))});
    run(world, 5000, 0.004);
    const RigidState& s = world.bodies[1].state;
    CHECK_THAT(g * (s.position.y() - 0.1) + s.velocity.squaredNorm() / 2,
               IsClose(g, Rounding(5000, g)));
}

TEST_CASE("collision: a cradle hands the impulse through", "[rigid]")
{
    for (const bool reversed : {false, true}) {
        std::vector<RigidBody> balls;
        for (int i = 0; i < 3; ++i)
            balls.push_back(
                body_of(Sphere{0.5}, {(reversed ? 2 - i : i) * 1.0, 0, 0}, material(1, 0)));
        RigidBody& first = balls[reversed ? 2 : 0];
        first.state.position.x() -= 0.01;
        first.state.velocity = {1, 0, 0};
        World world = world_of(balls, no_gravity);
        run(world, 3, 0.02);
        for (int i = 0; i < 3; ++i)
            CHECK_THAT(world.bodies[reversed ? 2 - i : i].state.velocity,
                       IsClose(Vector3d(i == 2 ? 1 : 0, 0, 0), Rounding(16, 1)));
    }
}

TEST_CASE("collision: a box that lands flat does not start to spin", "[rigid]")
{
    World world = world_of({fixed(Plane{}, material(1, 0.5)),
                            body_of(Box{{0.4, 0.2, 0.3}}, {0, 0.5, 0}, material(0.5, 0.5))});
    double top = 0;
    for (int i = 0; i < 100; ++i) {
        step(world, 0.01);
        if (world.bodies[1].state.velocity.y() > 0)
            top = std::max(top, world.bodies[1].state.position.y());
        REQUIRE_THAT(angular_velocity(world.bodies[1]),
                     IsClose(Vector3d(0, 0, 0), Rounding(64, 10)));
    }
    CHECK(top > 0.15); // the block did bounce
}

TEST_CASE("collision: a rocking block keeps seven tenths of its spin at a plastic impact",
          "[rigid]")
{
    // An upright block of width 1 and height 2. It rotates about its left edge and lands on its
    // right one.
    const double omega = 0.3;
    RigidBody block = body_of(Box{{1, 2, 1}}, {0, 1, 0}, material(0, 1e6));
    block.state.velocity = Vector3d(0, 0, -omega).cross(Vector3d(0.5, 1, 0));
    spin(block, {0, 0, -omega});
    World world = world_of({fixed(Plane{}, material(0, 1e6)), block}, no_gravity);
    step(world, 1e-9);
    CHECK_THAT(angular_velocity(world.bodies[1]),
               IsClose(Vector3d(0, 0, -0.7 * omega), Rounding(256, 1)));
}

TEST_CASE("collision: two balls keep their momentum and spin only by friction", "[rigid]")
{
    for (unsigned seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const double friction = seed % 2 ? 0.4 : 0.0;
        RigidBody a = body_of(Sphere{0.5}, {0, 0, 0}, material(0.7, friction));
        RigidBody b = body_of(Sphere{0.3}, 0.85 * random.unit_vector(), material(0.9, friction));
        b.state.velocity = -3 * b.state.position + random.vector();
        World world = world_of({a, b}, no_gravity);
        const Totals before = totals(world);
        run(world, 3, 0.02);
        const Totals after = totals(world);
        REQUIRE(world.counters.collision_impulses == 1);
        REQUIRE_THAT(after.momentum, IsClose(before.momentum, Rounding(32)));
        REQUIRE_THAT(after.angular_momentum,
                     IsClose(before.angular_momentum, Rounding(64, before.momentum.norm())));
        REQUIRE(after.kinetic_energy < before.kinetic_energy);
        const double spin = angular_velocity(world.bodies[0]).norm();
        REQUIRE((friction == 0 ? spin < 1e-14 : spin > 1e-6));
    }
}

TEST_CASE("collision: a fast ball does not pass through a thin wall", "[rigid]")
{
    RigidBody ball = body_of(Sphere{0.05}, {-1, 0, 0}, material(1, 0));
    ball.state.velocity = {100, 0, 0};
    World world = world_of({fixed(Box{{0.01, 2, 2}}, material(1, 0)), ball}, no_gravity);
    run(world, 3, 0.02); // two meters per step
    CHECK_THAT(world.bodies[1].state.velocity, IsClose(Vector3d(-100, 0, 0), Rounding(16)));
    CHECK(world.bodies[1].state.position.x() < 0);
}
