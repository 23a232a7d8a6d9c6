// SPDX-License-Identifier: MIT
// Laws that hold for any step: conservation, determinism, order of accuracy, and that skipped work
// changes nothing.
#include "framework/rigid/worlds.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "rigid/step/step.hpp"

#include <algorithm>

using namespace rigor;
using namespace rigor::testing;

namespace {

World pile_without_gravity(const std::function<Shape(Random&)>& shape, const Material& material)
{
    Random random(7);
    World world = world_of({}, {0, 0, 0});
    for (int i = 0; i < 64; ++i) {
        const Vector3d X(0.4 * (i % 4), 0.4 * (i / 4 % 4), 0.4 * (i / 16));
        RigidBody body = body_of(shape(random), X, material, random.quaternion());
        body.state.velocity = random.vector() - (X - Vector3d(0.6, 0.6, 0.6));
        spin(body, 3 * random.vector());
        world.bodies.push_back(body);
    }
    return world;
}

World pile(unsigned seed, int count)
{
    Random random(seed);
    std::vector<RigidBody> bodies = {fixed(Plane{}, {0.3, 0.5})};
    for (int i = 0; i < count; ++i) {
        const Vector3d X(0.6 * (i % 3 - 1), 0.4 + 0.6 * (i / 9), 0.6 * (i / 3 % 3 - 1));
        bodies.push_back(i % 4 == 3 ? body_of(Sphere{0.15}, X, {0.3, 0.5})
                                    : body_of(Box{{0.3, 0.3, 0.3}}, X + 0.05 * random.vector(),
                                              {0.3, 0.5}, random.quaternion()));
    }
    return world_of(bodies);
}

bool same_bits(const RigidState& a, const RigidState& b)
{
    return a.position == b.position && a.velocity == b.velocity &&
           a.angular_momentum == b.angular_momentum && a.orientation.s == b.orientation.s &&
           a.orientation.v == b.orientation.v;
}

} // namespace

TEST_CASE("step: a pile without gravity keeps momentum and never gains energy", "[rigid]")
{
    World world = pile_without_gravity([](Random&) { return Sphere{0.15}; }, {0.9, 0.3});
    const Totals start = totals(world);
    double energy = start.kinetic_energy;
    const int steps = 300;
    for (int i = 0; i < steps; ++i) {
        step(world, 0.01);
        const double now = totals(world).kinetic_energy;
        check_at_most(now, energy, "kinetic energy", 64 * energy);
        energy = now;
    }
    CHECK(world.counters.collision_impulses > 50);
    double scale = 0; // Σ |X| M |V|
    for (const RigidBody& body : world.bodies)
        scale += body.mass * body.state.velocity.norm() * (1 + body.state.position.norm());
    CHECK_THAT(totals(world).momentum, IsClose(start.momentum, Rounding(steps, scale)));
    CHECK_THAT(totals(world).angular_momentum,
               IsClose(start.angular_momentum, Rounding(steps, scale)));
}

TEST_CASE("step: tumbling boxes keep momentum and angular momentum", "[rigid]")
{
    World world = pile_without_gravity(
        [](Random& random) {
            return Box{{random.uniform(0.1, 0.25), 0.15, 0.2}};
        },
        {0.5, 0.4});
    const Totals start = totals(world);
    run(world, 300, 0.01);
    CHECK(world.counters.collision_impulses > 50);
    double scale = 0;
    for (const RigidBody& body : world.bodies)
        scale += body.mass * body.state.velocity.norm() * (1 + body.state.position.norm());
    CHECK_THAT(totals(world).momentum, IsClose(start.momentum, Rounding(300, scale)));
    CHECK_THAT(totals(world).angular_momentum,
               IsClose(start.angular_momentum, Rounding(300, scale)));
    CHECK(totals(world).kinetic_energy < start.kinetic_energy);
}

TEST_CASE("step: the same world gives the same bits", "[rigid]")
{
    World a = pile(3, 27), b = a;
    for (int i = 0; i < 120; ++i) {
        step(a, 0.01);
        World fresh = b; // nothing is remembered apart from the world
        fresh.counters = {};
        step(fresh, 0.01);
        b = fresh;
    }
    for (std::size_t i = 0; i < a.bodies.size(); ++i)
        REQUIRE(same_bits(a.bodies[i].state, b.bodies[i].state));
}

TEST_CASE("step: the order of the bodies does not matter", "[rigid]")
{
    World world = pile(3, 18), shuffled = world;
    std::vector<std::size_t> places(world.bodies.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] = (7 * i + 4) % places.size(); // with 19 bodies, each place is taken once
        shuffled.bodies[places[i]] = world.bodies[i];
    }
    // This is beyond the first impacts, but chaos has not yet amplified rounding too much.
    run(world, 45, 0.01);
    run(shuffled, 45, 0.01);
    CHECK(world.counters.collision_impulses > 5);
    for (std::size_t i = 0; i < places.size(); ++i)
        CHECK_THAT(shuffled.bodies[places[i]].state.position,
                   IsClose(world.bodies[i].state.position, Rounding(64)));
}

TEST_CASE("step: a body far away changes no bit of the others", "[rigid]")
{
    World alone = pile(5, 9), watched = alone;
    watched.bodies.push_back(body_of(Box{{1, 2, 3}}, {1000, 2000, 0}, {}, turn({1, 1, 0}, 1)));
    watched.bodies.push_back(fixed(Sphere{1}, {}, {-500, 10, 0}));
    run(alone, 100, 0.01);
    run(watched, 100, 0.01);
    for (std::size_t i = 0; i < alone.bodies.size(); ++i)
        REQUIRE(same_bits(alone.bodies[i].state, watched.bodies[i].state));
}

TEST_CASE("step: a body that touches nothing flies as if nothing were there", "[rigid]")
{
    RigidBody box = body_of(Box{{1, 2, 3}}, {0, 20, 0});
    spin(box, {1, 2, 3});
    World alone = world_of({box}),
          world = world_of({box, fixed(Plane{}, {}), fixed(Box{{1, 1, 1}}, {}, {0, 30, 0})});
    run(alone, 100, 0.01);
    run(world, 100, 0.01);
    CHECK(same_bits(alone.bodies[0].state, world.bodies[0].state));
    CHECK(world.counters.free_flights == 100);
    CHECK(world.counters.static_skipped == 200);
    CHECK(world.counters.contacts == 0);
    CHECK(world.counters.steps == 100);
}

TEST_CASE("step: a pile settles calmly", "[rigid]")
{
    World world = pile(1, 45);
    run(world, 480, 1.0 / 120);
    double deepest = 0;
    for (int i = 0; i < 60; ++i)
        for (const ContactRecord& contact : step(world, 1.0 / 120))
            deepest = std::max(deepest, contact.depth);
    CHECK(deepest < 0.004);
    double fastest = 0; // highest speed of the boxes, since balls may roll away
    for (const RigidBody& body : world.bodies) {
        CHECK(body.state.position.y() > -1e-3);
        if (std::holds_alternative<Box>(body.parts[0].shape))
            fastest = std::max(fastest, body.state.velocity.norm());
    }
    CHECK(fastest < 0.1);
}

TEST_CASE("step: what is not a number is reported by body quantity and time", "[rigid]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto quantity_of = [](const RigidState& state) -> std::string {
        World world = pile(1, 9);
        run(world, 4, 0.01);
        world.bodies[4].name = "die";
        world.bodies[4].state = state;
        try {
            step(world, 0.01);
        } catch (const NonFiniteState& e) {
            CHECK(e.body == "die");
            CHECK(std::abs(e.time - 0.05) < 1e-12);
            return e.quantity;
        }
        return "nothing";
    };
    RigidState state;
    state.position = {50, 50, 50};
    CHECK(quantity_of(state) == "nothing");
    RigidState bad = state;
    bad.position.x() = nan;
    CHECK(quantity_of(bad) == "position X");
    bad = state;
    bad.orientation.s = nan;
    CHECK(quantity_of(bad) == "orientation q");
    bad = state;
    bad.angular_momentum.y() = nan;
    CHECK(quantity_of(bad) == "orientation q"); // q is rotated by L before L itself is checked
    bad = state;
    bad.velocity.z() = std::numeric_limits<double>::infinity();
    CHECK(quantity_of(bad) == "position X"); // V has changed the position by the end of the step
}

TEST_CASE("step: an empty world takes its steps", "[rigid]")
{
    World world;
    CHECK(step(world, 0.5).empty());
    CHECK(world.time == 0.5);
    CHECK(world.counters.steps == 1);
}

TEST_CASE("step: a step that takes no time moves nothing and the next one goes on", "[rigid]")
{
    for (const ContactMethod method :
         {ContactMethod::built_in, ContactMethod::one_at_a_time, ContactMethod::shock_propagation,
          ContactMethod::simultaneous})
        for (const double restitution : {0.0, 0.5, 1.0}) {
            CAPTURE(static_cast<int>(method), restitution);
            const Material material{restitution, 0.5};
            World world =
                world_of({fixed(Plane{}, material), body_of(Box{{1, 1, 1}}, {0, 0.5, 0}, material),
                          body_of(Box{{1, 1, 1}}, {0, 1.5, 0}, material),
                          body_of(Sphere{0.5}, {3, 0.5, 0}, material),
                          body_of(Sphere{0.5}, {5, 0.45, 0}, material)});
            world.settings.contact_method = method;
            for (int i : {3, 4}) // they arrive, one of them in the ground already
                world.bodies[i].state.velocity = {1, -2, 0};
            const World before = world;
            step(world, 0);
            step(world, 0);
            CHECK(world.time == 0);
            for (std::size_t i = 0; i < before.bodies.size(); ++i) {
                CHECK(world.bodies[i].state.position == before.bodies[i].state.position);
                CHECK_THAT(world.bodies[i].state.orientation,
                           IsExactly(before.bodies[i].state.orientation));
            }
            run(world, 20, 0.01);
            for (int i : {1, 2}) // the stack stands
                CHECK_THAT(world.bodies[i].state.position,
                           IsClose(before.bodies[i].state.position, Order(1e-3)));
            for (int i : {3, 4})
                CHECK(world.bodies[i].state.position.y() > 0.4);
        }
}
