// SPDX-License-Identifier: MIT
// Work that a step skips changes nothing, or no more than these tests allow.
#include "framework/rigid/worlds.hpp"
#include "rigid/contact/warm_start.hpp"
#include "rigid/step/step.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 1.0 / 60;

World stacks(int count, int height)
{
    std::vector<RigidBody> bodies = {fixed(Plane{}, {0, 0.5})};
    Random random(7);
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < height; ++k)
            bodies.push_back(body_of(Box{{1, 1, 1}},
                                     Vector3d(3 * i + 0.01 * random.uniform(-1, 1), 0.5 + k,
                                              0.01 * random.uniform(-1, 1)),
                                     {0, 0.5}));
    World world = world_of(bodies);
    world.settings.contact_method = ContactMethod::simultaneous;
    world.settings.formulas_are_reference = true;
    return world;
}

// Randomly placed cubes that fall on each other in a room without a roof.
World heap(int side)
{
    const double w = 0.75 * side + 0.5;
    std::vector<RigidBody> bodies = {fixed(Plane{}, {0, 0.5})};
    for (const Vector3d& out : {Vector3d(1, 0, 0), Vector3d(0, 0, 1)})
        for (double sign : {-1.0, 1.0})
            bodies.push_back(
                fixed(Box{{2 * w + 1, 40, 2 * w + 1}}, {0, 0.5}, sign * (2 * w + 0.5) * out));
    Random random(3);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (int z = 0; z < side; ++z) {
                const Vector3d cell(x - (side - 1) / 2.0, y + 0.6, z - (side - 1) / 2.0);
                bodies.push_back(body_of(Box{{1, 1, 1}}, 1.5 * cell + 0.2 * random.vector(),
                                         {0, 0.5},
                                         turn(random.unit_vector(), random.uniform(0, 0.25))));
            }
    World world = world_of(bodies);
    world.settings.contact_method = ContactMethod::simultaneous;
    world.settings.formulas_are_reference = true;
    return world;
}

double largest_distance(const World& a, const World& b)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.bodies.size(); ++i)
        largest =
            std::max(largest, (a.bodies[i].state.position - b.bodies[i].state.position).norm());
    return largest;
}

} // namespace

TEST_CASE("skips: without islands warm start or early exit stacks stand as with them", "[rigid]")
{
    const auto without = GENERATE(&Skips::islands, &Skips::warm_start, &Skips::early_exit);
    World with = stacks(3, 5), other = with;
    with.settings.skips.sleep = other.settings.skips.sleep = false;
    other.settings.skips.*without = false;
    run(with, 120, h);
    run(other, 120, h);
    CHECK(with.counters.warm_starts > 1000);
    CHECK(with.counters.early_exits > 100);
    CHECK(with.counters.islands == 3 * 120);
    if (without == &Skips::islands) CHECK(other.counters.islands == 120);
    if (without == &Skips::warm_start) CHECK(other.counters.warm_starts == 0);
    if (without == &Skips::early_exit) CHECK(other.counters.early_exits == 0);
    // Both stand still up to the tolerance of the sweeps.
    CHECK(largest_distance(with, other) < 1e-6);
}

TEST_CASE("skips: bodies at rest sleep where they are and keep their contacts", "[rigid]")
{
    World sleeping = stacks(2, 4), awake = sleeping;
    awake.settings.skips.sleep = false;
    run(sleeping, 120, h);
    run(awake, 120, h);
    CHECK(awake.counters.bodies_asleep == 0);
    CHECK(sleeping.counters.bodies_asleep > 8 * 60);
    for (std::size_t i = 1; i < sleeping.bodies.size(); ++i)
        CHECK(sleeping.bodies[i].rest.is_asleep());
    CHECK(largest_distance(sleeping, awake) < 1e-4 * std::sqrt(3) / 2); // limit for a body at rest

    // The ground still carries the whole weight.
    double weight = 0, mass = 0;
    for (const ContactRecord& c : step(sleeping, h))
        if (sleeping.bodies[c.body1].is_static || sleeping.bodies[c.body2].is_static)
            weight += std::abs(c.impulse.y()) / h;
    for (const RigidBody& body : sleeping.bodies)
        mass += body.mass;
    CHECK_THAT(weight, IsClose(mass * g, Order(1e-3 * mass * g)));
}

TEST_CASE("skips: what is hit wakes with all that fell asleep with it and no other", "[rigid]")
{
    World world = stacks(2, 3);
    run(world, 60, h);
    REQUIRE(world.bodies[1].rest.is_asleep());
    RigidBody ball = body_of(Sphere{0.3}, {-4, 2.5, 0}, {0, 0.5});
    ball.state.velocity = {20, 0, 0};
    world.bodies.push_back(ball);
    double speed = 0;
    for (int i = 0; i < 20; ++i) {
        step(world, h);
        speed = std::max(speed, world.bodies[3].state.velocity.x());
    }
    CHECK(speed > 0.1);
    for (int i : {1, 2, 3})
        CHECK_FALSE(world.bodies[i].rest.is_asleep());
    for (int i : {4, 5, 6})
        CHECK(world.bodies[i].rest.is_asleep());
}

TEST_CASE("skips: a block that begins to slip does not sleep", "[rigid]")
{
    const double angle = std::atan(0.5) + 1e-3;
    const Quaternion slope = turn(Vector3d::UnitZ(), angle);
    const Matrix3d R = rotation_matrix(slope);
    World world = world_of({fixed(Plane{}, {0, 0.5}, {0, 0, 0}, slope),
                            body_of(Box{{1, 1, 1}}, R * Vector3d(0, 0.5, 0), {0, 0.5}, slope)});
    run(world, 200, 0.01);
    CHECK(world.counters.bodies_asleep == 0);
    CHECK(world.bodies[1].state.velocity.norm() > 0.01);
}

TEST_CASE("skips: a heap comes to rest and sleeps where it would lie awake", "[rigid]")
{
    World sleeping = heap(4), awake = sleeping;
    const auto all_sleep = [&] {
        return std::all_of(sleeping.bodies.begin(), sleeping.bodies.end(),
                           [](const RigidBody& body) { return body.is_still(); });
    };
    for (int i = 0; !all_sleep() && i < 1200; ++i) {
        awake = sleeping; // one step behind
        step(sleeping, h);
    }
    REQUIRE(all_sleep());
    const std::uint64_t before = sleeping.counters.bodies_asleep;

    // Awake, the heap would stay in its place for the next half second as it did for the last one.
    awake.settings.skips.sleep = false;
    for (RigidBody& body : awake.bodies)
        body.rest = {};
    awake.memory.sleeping_contacts.clear();
    run(awake, 31, h);
    run(sleeping, 30, h);
    CHECK(sleeping.counters.bodies_asleep - before == 30 * 64);
    CHECK(largest_distance(sleeping, awake) < 1e-4 * std::sqrt(3) / 2); // limit for a body at rest
}

TEST_CASE("skips: what moves slowly does not sleep", "[rigid]")
{
    // Almost upright on an edge, and so about to fall.
    const Quaternion tilt = turn(Vector3d::UnitZ(), std::numbers::pi / 4 + 1e-3);
    RigidBody leaning = body_of(Box{{1, 1, 1}}, {0, std::sqrt(0.5), 0}, {0, 0.5}, tilt);
    RigidBody gliding = body_of(Box{{1, 1, 1}}, {5, 0.5, 0}, {0, 0});
    gliding.state.velocity = {1e-3, 0, 0}; // moves 0.2 mm in the time that is needed for sleep
    World world = world_of({fixed(Plane{}, {0, 0.5}), leaning, gliding});
    run(world, 60, h);
    CHECK(world.counters.bodies_asleep == 0);
    CHECK(world.bodies[2].state.position.x() > 5 + 0.9e-3);
    run(world, 120, h);
    CHECK(world.bodies[1].state.position.y() < 0.55); // the leaning box fell
}

TEST_CASE("skips: a contact that carries nothing leaves its neighbour's impulse alone", "[rigid]")
{
    World world = world_of({fixed(Plane{}, {0, 0.5}), body_of(Box{{1, 1, 1}}, {0, 0.5, 0})});
    const Vector3d loaded(0.5, 0, 0.5), empty(0.48, 0, 0.5), force(0, -7, 0);
    world.memory.warm_contacts = {{0, 1, loaded, force}};
    std::vector<ContactConstraint> contacts(2);
    for (ContactConstraint& c : contacts) {
        c.body1 = 0;
        c.body2 = 1;
        c.normal = {0, -1, 0};
        c.radius = 1;
    }
    for (const bool is_first : {true, false}) { // whichever contact comes first
        CAPTURE(is_first);
        contacts[0].point = is_first ? empty : loaded;
        contacts[1].point = is_first ? loaded : empty;
        contacts[0].initial_impulse = contacts[1].initial_impulse = Vector3d::Zero();
        const std::vector<ContactPair> pairs = {{0, 2}};
        const std::vector<Pose> poses = {{}, {Matrix3d::Identity(), {0, 0.5, 0}}};
        CHECK(start_warm(world.memory.warm_contacts, poses, h, pairs, contacts) == 1);
        CHECK(contacts[is_first].initial_impulse == h * force);
        CHECK(contacts[!is_first].initial_impulse == Vector3d::Zero());
    }
}

TEST_CASE("skips: a body that is alone flies as it does far from others", "[rigid]")
{
    RigidBody body = body_of(Box{{1, 2, 3}}, {0, 5, 0});
    body.state.velocity = {1, 2, 3};
    body.state.angular_momentum = 4000 * Vector3d(3, 1, 2);
    for (Integrator integrator : {Integrator::matrix, Integrator::linear, Integrator::exponential,
                                  Integrator::buss, Integrator::runge_kutta}) {
        CAPTURE(static_cast<int>(integrator));
        World alone = world_of({body}), two = world_of({body, fixed(Box{{1, 1, 1}}, {0, 0.5})});
        two.bodies[1].state.position = {1000, 0, 0};
        alone.settings.integrator = two.settings.integrator = integrator;
        for (int i = 0; i < 50; ++i) {
            REQUIRE(step(alone, h).empty());
            REQUIRE(step(two, h).empty());
        }
        const RigidState &a = alone.bodies[0].state, &b = two.bodies[0].state;
        CHECK(a.position == b.position);
        CHECK(a.orientation.s == b.orientation.s);
        CHECK(a.orientation.v == b.orientation.v);
        CHECK(a.velocity == b.velocity);
        CHECK(a.angular_momentum == b.angular_momentum);
        CHECK(alone.time == two.time);
        CHECK(alone.counters.steps == two.counters.steps);
        CHECK(alone.counters.substeps == two.counters.substeps);
        CHECK(alone.counters.free_flights == two.counters.free_flights);
    }
}
