// SPDX-License-Identifier: MIT
// Bodies at rest sleep, and wake when something could move them.
#include "framework/rigid/worlds.hpp"
#include "rigid/step/sleep.hpp"
#include "rigid/step/step.hpp"

namespace sleep_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 1.0 / 60; // [s]

// Randomly placed cubes that fall on each other in a room without a roof.
World cubic_pile(int side, int seed)
{
    const double w = 0.75 * side + 0.5;
    std::vector<RigidBody> bodies = {fixed(Plane{}, {0, 0.5})};
    for (const Vector3d& out : {Vector3d(1, 0, 0), Vector3d(0, 0, 1)})
        for (double sign : {-1.0, 1.0})
            bodies.push_back(
                fixed(Box{{2 * w + 1, 40, 2 * w + 1}}, {0, 0.5}, sign * (2 * w + 0.5) * out));
    Random random(seed);
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

constexpr double at_rest = 1e-4 * std::numbers::sqrt3 / 2; // limit for a cube of 1 m at rest [m]

// Piles of side³ cubes, by side and seed. Some piles of 64 cubes have several islands, which fall
// asleep one by one.
constexpr std::pair<int, int> piles[] = {{2, 1},  {2, 6}, {3, 1}, {3, 9},
                                         {3, 12}, {4, 3}, {4, 4}, {4, 12}};

bool all_sleep(const World& world)
{
    return std::all_of(world.bodies.begin(), world.bodies.end(),
                       [](const RigidBody& body) { return body.is_still(); });
}

// Wakes all bodies, which cannot sleep any more.
void wake_all(World& world)
{
    world.settings.optimisations.sleep = false;
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
        if (world.bodies[i].rest.is_asleep()) wake(world, {static_cast<int>(i)});
}

} // namespace

TEST_CASE("sleep: bodies at rest sleep where they are and keep their contacts", "[rigid]")
{
    World sleeping = stacks(2, 4), awake = sleeping;
    awake.settings.optimisations.sleep = false;
    run(sleeping, 120, h);
    run(awake, 120, h);
    CHECK(awake.counters.bodies_asleep == 0);
    CHECK(sleeping.counters.bodies_asleep > 8 * 60);
    for (std::size_t i = 1; i < sleeping.bodies.size(); ++i)
        CHECK(sleeping.bodies[i].rest.is_asleep());
    CHECK(largest_distance(sleeping, awake) < at_rest);

    // The ground still carries the whole weight.
    double weight = 0, mass = 0;
    for (const ContactRecord& c : step(sleeping, h))
        if (sleeping.bodies[c.body1].is_static || sleeping.bodies[c.body2].is_static)
            weight += std::abs(c.impulse.y()) / h;
    for (const RigidBody& body : sleeping.bodies)
        mass += body.mass;
    CHECK_THAT(weight, IsClose(mass * g, Order(1e-3 * mass * g)));
}

TEST_CASE("sleep: what is hit wakes with all that fell asleep with it and no other", "[rigid]")
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

TEST_CASE("sleep: a block that begins to slip does not sleep", "[rigid]")
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

TEST_CASE("sleep: a pile comes to rest and sleeps where it would lie awake", "[rigid][unsanitized]")
{
    for (const auto& [side, seed] : piles) {
        CAPTURE(side, seed);
        World sleeping = cubic_pile(side, seed), awake = sleeping;
        for (int i = 0; !all_sleep(sleeping) && i < 1200; ++i) {
            awake = sleeping; // one step behind
            step(sleeping, h);
        }
        REQUIRE(all_sleep(sleeping));
        const std::uint64_t before = sleeping.counters.bodies_asleep;

        // Awake, the pile stays in its place for the next half second as it did for the last one.
        wake_all(awake);
        run(awake, 31, h);
        run(sleeping, 30, h);
        CHECK(sleeping.counters.bodies_asleep - before == 30u * side * side * side);
        CHECK(largest_distance(sleeping, awake) < at_rest);
    }
}

// Without the impulses that it had before its sleep, a large pile would jump when it wakes: the
// sweeps of the first step would not find all impulses anew.
TEST_CASE("sleep: a pile that wakes stays in its place", "[rigid][unsanitized]")
{
    for (const auto& [side, seed] : piles) {
        CAPTURE(side, seed);
        World sleeping = cubic_pile(side, seed);
        for (int i = 0; !all_sleep(sleeping) && i < 1200; ++i)
            step(sleeping, h);
        REQUIRE(all_sleep(sleeping));
        World woken = sleeping;
        wake_all(woken);
        run(woken, 30, h);
        CHECK(largest_distance(sleeping, woken) < 0.1 * at_rest);
    }
}

TEST_CASE("sleep: what moves slowly does not sleep", "[rigid]")
{
    // This box stands almost upright on an edge and is about to fall.
    const Quaternion tilt = turn(Vector3d::UnitZ(), std::numbers::pi / 4 + 1e-3);
    RigidBody leaning = body_of(Box{{1, 1, 1}}, {0, std::sqrt(0.5), 0}, {0, 0.5}, tilt);
    RigidBody gliding = body_of(Box{{1, 1, 1}}, {5, 0.5, 0}, {0, 0});
    gliding.state.velocity = {1e-3, 0, 0}; // moves 0.5 mm in the 0.5 s of rest that sleep needs
    World world = world_of({fixed(Plane{}, {0, 0.5}), leaning, gliding});
    run(world, 60, h);
    CHECK(world.counters.bodies_asleep == 0);
    CHECK(world.bodies[2].state.position.x() > 5 + 0.9e-3);
    run(world, 120, h);
    CHECK(world.bodies[1].state.position.y() < 0.55); // the leaning box fell
}

} // namespace sleep_test
