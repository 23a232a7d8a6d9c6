// SPDX-License-Identifier: MIT
// Resting, sliding and rolling, compared with results computed by hand.
#include "framework/rigid/worlds.hpp"
#include "rigid/step/step.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

// A block on an incline, which is rotated about z, and the directions of the incline.
struct Incline {
    World world;
    Vector3d down, normal;
    Vector3d start;

    double slid() const { return down.dot(world.bodies[1].state.position - start); }
};

Incline incline(double angle, double friction, double restitution, bool on_box, double heading = 0)
{
    const Quaternion tilt = turn({0, 0, 1}, -angle);
    const Matrix3d R = rotation_matrix(tilt);
    Incline made;
    made.down = R.col(0);
    made.normal = R.col(1);
    made.start = 0.1 * made.normal;
    const Material material{restitution, friction};
    RigidBody ground = fixed(Plane{}, material, {0, 0, 0}, tilt);
    if (on_box) ground = fixed(Box{{20, 1, 6}}, material, -0.5 * made.normal, tilt);
    RigidBody block = body_of(Box{{0.4, 0.2, 0.3}}, made.start, material);
    block.state.orientation = quaternion_of(R * rotation_matrix(turn({0, 1, 0}, heading)));
    made.world = world_of({ground, block});
    return made;
}

constexpr double thirty_degrees = std::numbers::pi / 6;

} // namespace

TEST_CASE("contact: a block slides down an incline with its textbook acceleration to rounding",
          "[rigid]")
{
    const double h = 0.01, a = g * (std::sin(thirty_degrees) - 0.2 * std::cos(thirty_degrees));
    CHECK_THAT(a, IsClose(3.20585815777493, Rounding(16)));
    for (const bool on_box : {false, true})
        for (const double restitution : {0.0, 1.0}) {
            Incline slope = incline(thirty_degrees, 0.2, restitution, on_box);
            for (int n = 1; n <= 100; ++n) {
                step(slope.world, h);
                REQUIRE_THAT(slope.slid(), IsClose(a * h * h * n * n / 2, Rounding(64 * n, 1)));
                REQUIRE_THAT(slope.world.bodies[1].state.angular_momentum,
                             IsClose(Vector3d(0, 0, 0), Rounding(64 * n, 1)));
            }
            CHECK_THAT(slope.normal.dot(slope.world.bodies[1].state.position),
                       IsClose(0.1, Rounding(64, 1)));
        }
}

TEST_CASE("contact: by an integrator of first order a block slides with the velocities of the ends",
          "[rigid]")
{
    const double h = 0.01, a = g * (std::sin(thirty_degrees) - 0.2 * std::cos(thirty_degrees));
    for (const Integrator integrator :
         {Integrator::linear, Integrator::exponential, Integrator::buss}) {
        Incline slope = incline(thirty_degrees, 0.2, 0.5, false);
        slope.world.settings.integrator = integrator;
        run(slope.world, 100, h);
        CHECK_THAT(slope.slid(), IsClose(a * h * h * 100 * 101 / 2, Rounding(6400, 1)));
    }
}

TEST_CASE("contact: what swings on a smooth ground keeps its energy", "[rigid]")
{
    RigidBody block = body_of(Box{{0.2, 0.2, 0.2}}, {1, 0.1, 0}, {0, 0});
    World world = world_of({fixed(Plane{}, {0, 0}), block});
    Spring spring;
    spring.body1 = 1;
    spring.point2 = {0, 0.1, 0};
    spring.stiffness = 30 * block.mass; // [N/m], so that ω² = 30 s⁻²
    world.springs = {spring};
    double fastest = 0; // highest speed of the last swings [m/s]
    for (int n = 0; n < 6000; ++n) {
        step(world, 1.0 / 120);
        if (n >= 5700) fastest = std::max(fastest, world.bodies[1].state.velocity.norm());
    }
    CHECK_THAT(fastest, IsClose(std::sqrt(30.0), Order(5e-3)));
}

TEST_CASE("contact: what rocks on a smooth ground gains no energy", "[rigid]")
{
    RigidBody lens = body_of(Ellipsoid{{0.6, 0.2, 0.6}}, {0, 0.3, 0}, {0, 0}, turn({0, 0, 1}, 0.3));
    World world = world_of({fixed(Plane{}, {0, 0}), lens});
    double first = 0, last = 0; // highest |ω| of early and of late steps [rad/s]
    for (int n = 0; n < 6000; ++n) {
        step(world, 1.0 / 120);
        const double speed = angular_velocity(world.bodies[1]).norm();
        if (n > 120 && n < 600) first = std::max(first, speed);
        if (n >= 5400) last = std::max(last, speed);
    }
    CHECK(first > 0.1);
    CHECK(last <= first);
}

TEST_CASE("contact: what lands does not go into the ground", "[rigid]")
{
    World world = world_of({fixed(Plane{}, {0, 0}), body_of(Box{{1, 1, 1}}, {0, 1.5, 0}, {0, 0})});
    world.settings.contact_method = ContactMethod::simultaneous; // resolves the impact as a contact
    for (int n = 0; n < 60; ++n) {
        step(world, 1.0 / 60);
        REQUIRE(world.bodies[1].state.position.y() > 0.5 - 1e-12);
    }
}

TEST_CASE("contact: a block that sticks does not move at all whatever its restitution", "[rigid]")
{
    for (const bool on_box : {false, true})
        for (const double restitution : {0.0, 0.5, 1.0}) {
            Incline slope = incline(thirty_degrees, 0.7, restitution, on_box);
            const RigidState before = slope.world.bodies[1].state;
            run(slope.world, 300, 0.01);
            const RigidState& after = slope.world.bodies[1].state;
            CHECK_THAT(after.position, IsClose(before.position, Rounding(8)));
            CHECK_THAT(after.orientation, IsClose(before.orientation, Rounding(8)));
            CHECK_THAT(after.velocity, IsClose(Vector3d(0, 0, 0), Rounding(8, 1)));
        }
}

TEST_CASE("contact: a block turned to any heading still slides straight down", "[rigid]")
{
    const double h = 0.01, a = g * (std::sin(thirty_degrees) - 0.2 * std::cos(thirty_degrees));
    Incline slope = incline(thirty_degrees, 0.2, 0.5, false, 17 * std::numbers::pi / 180);
    run(slope.world, 100, h);
    const RigidState& s = slope.world.bodies[1].state;
    CHECK_THAT(Vector3d(s.position - slope.start),
               IsClose(Vector3d(a * h * h * 5000 * slope.down), Rounding(6400, 1)));
}

TEST_CASE("contact: stick turns into slip where the slope's tangent is the friction", "[rigid]")
{
    const double critical = std::atan(0.4), hundredth = 0.01 * std::numbers::pi / 180;
    Incline sticks = incline(critical - hundredth, 0.4, 0.5, false),
            slips = incline(critical + hundredth, 0.4, 0.5, false);
    run(sticks.world, 200, 0.01);
    run(slips.world, 200, 0.01);
    CHECK(std::abs(sticks.slid()) < 1e-5); // at the limit the iteration converges slowly
    const double a = g * (std::sin(critical + hundredth) - 0.4 * std::cos(critical + hundredth));
    CHECK_THAT(slips.slid(), IsClose(a * 1e-4 * 200 * 200 / 2, Order(1e-5)));
    CHECK(slips.slid() > 1e-3);
}

TEST_CASE("contact: a sliding ball ends rolling with five sevenths of its speed", "[rigid]")
{
    const double h = 1e-3;
    RigidBody ball = body_of(Sphere{0.1}, {0, 0.1, 0}, {0.5, 0.2});
    ball.state.velocity = {1, 0, 0};
    World world = world_of({fixed(Plane{}, {1, 0.2}), ball});
    double rolls_at = 0;
    for (int i = 0; i < 400; ++i) {
        step(world, h);
        const RigidBody& b = world.bodies[1];
        const double slip = b.state.velocity.x() + 0.1 * angular_velocity(b).z();
        if (rolls_at == 0 && std::abs(slip) < 1e-12) {
            rolls_at = world.time;
            CHECK(std::abs(b.state.position.x() - 0.124820570430007) < h);
        }
    }
    CHECK(std::abs(rolls_at - 0.145623998835008) < h);
    CHECK_THAT(world.bodies[1].state.velocity, IsClose(Vector3d(5. / 7, 0, 0), Rounding(64, 1)));
    CHECK_THAT(world.bodies[1].state.position.y(), IsClose(0.1, Rounding(16)));
}

TEST_CASE("contact: friction is a cone so a turned scene gives a turned result", "[rigid]")
{
    const auto end = [](double heading) {
        const Matrix3d R = rotation_matrix(turn({0, 1, 0}, heading));
        RigidBody box = body_of(Box{{0.4, 0.2, 0.3}}, {0, 0.1, 0}, {0.5, 0.3}, quaternion_of(R));
        box.state.velocity = R * Vector3d(2, 0, 1);
        RigidBody ball = body_of(Sphere{0.2}, R * Vector3d(3, 0.2, 0), {0.5, 0.3});
        ball.state.velocity = R * Vector3d(-1, 0, 2);
        World world = world_of({fixed(Plane{}, {0.5, 0.3}), box, ball});
        run(world, 60, 0.01);
        return std::pair<Vector3d, Vector3d>(R.transpose() * world.bodies[1].state.position,
                                             R.transpose() * world.bodies[2].state.position);
    };
    const double heading = 17 * std::numbers::pi / 180;
    CHECK_THAT(end(heading).first, IsClose(end(0).first, Rounding(64 * 60)));
    CHECK_THAT(end(heading).second, IsClose(end(0).second, Rounding(64 * 60)));
}

TEST_CASE("contact: stacks of five and ten cubes stand for ten seconds", "[rigid]")
{
    for (const int n : {5, 10}) {
        std::vector<RigidBody> bodies = {fixed(Plane{}, {0.2, 0.5})};
        for (int i = 0; i < n; ++i)
            bodies.push_back(body_of(Box{{1, 1, 1}}, {0, 0.5 + i, 0}, {0.2, 0.5}));
        World world = world_of(bodies);
        run(world, 600, 1.0 / 60);
        for (int i = 0; i < n; ++i)
            CHECK((world.bodies[i + 1].state.position - Vector3d(0, 0.5 + i, 0)).norm() < 0.05);
    }
}

TEST_CASE("contact: a stack of thirty cubes stands where it was put", "[rigid]")
{
    for (const ContactMethod method : {ContactMethod::built_in, ContactMethod::simultaneous}) {
        std::vector<RigidBody> bodies = {fixed(Plane{}, {0, 0.5})};
        Random random(2);
        for (int i = 0; i < 30; ++i)
            bodies.push_back(body_of(
                Box{{1, 1, 1}},
                {0.01 * random.uniform(-1, 1), 0.5 + i, 0.01 * random.uniform(-1, 1)}, {0, 0.5}));
        World world = world_of(bodies);
        world.settings.contact_method = method;
        world.settings.optimisations.sleep = false;
        run(world, 120, 1.0 / 60);
        for (std::size_t i = 1; i < bodies.size(); ++i)
            CHECK_THAT(world.bodies[i].state.position,
                       IsClose(bodies[i].state.position, Order(1e-5)));
    }
}

TEST_CASE("contact: ten thousand times its mass on a cube does not press it into the ground",
          "[rigid]")
{
    RigidBody heavy = body_of(Box{{1, 1, 1}}, {0, 1.5, 0}, {0, 0.5});
    set_mass(heavy, 1e4 * heavy.mass, 1e4 * heavy.inertia);
    World world =
        world_of({fixed(Plane{}, {0, 0.5}), body_of(Box{{1, 1, 1}}, {0, 0.5, 0}, {0, 0.5}), heavy});
    world.settings.optimisations.sleep = false;
    run(world, 300, 1.0 / 60);
    CHECK_THAT(world.bodies[1].state.position, IsClose(Vector3d(0, 0.5, 0), Order(1e-6)));
    CHECK_THAT(world.bodies[2].state.position, IsClose(Vector3d(0, 1.5, 0), Order(1e-6)));
}
