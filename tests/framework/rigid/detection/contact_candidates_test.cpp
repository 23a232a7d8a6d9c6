// SPDX-License-Identifier: MIT
#include "rigid/detection/contact_candidates.hpp"

#include "framework/rigid/worlds.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "rigid/motion/free_flight.hpp"
#include "support/seeds.hpp"

#include <set>

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double tenth = 0.1; // the time step [s]

ContactCandidates candidates_of(World& world, double time_step = tenth, int threads = 1)
{
    ThreadPool pool(threads);
    const std::vector<bool> pulled(world.bodies.size(), false);
    const std::vector<RigidState> flown = fly_all(world, pulled, time_step, pool);
    return contact_candidates(world, flown, time_step, pool);
}

// Balls of radius ½ m in a row along x with these gaps between them. The first one moves at 2 m/s,
// by 0.2 m in a step. A ball far away, the last of the list, stands still.
World row_of_balls(const std::vector<double>& gaps, double restitution)
{
    std::vector<RigidBody> balls = {body_of(Sphere{0.5}, {0, 0, 0}, {restitution, 0})};
    balls[0].state.velocity = {2, 0, 0};
    for (const double gap : gaps)
        balls.push_back(body_of(Sphere{0.5}, balls.back().state.position + Vector3d(1 + gap, 0, 0),
                                {restitution, 0}));
    balls.push_back(fixed(Sphere{0.5}, {}, {-1000, 0, 0}));
    return world_of(std::move(balls), {0, 0, 0});
}

std::set<std::pair<int, int>> pairs_in(const ContactCandidates& candidates)
{
    std::set<std::pair<int, int>> pairs;
    for (const Contact& c : candidates.contacts)
        pairs.emplace(std::min(c.body1, c.body2), std::max(c.body1, c.body2));
    return pairs;
}

const Shape round_shapes[] = {Sphere{0.3},         Capsule{0.2, 0.5},
                              Cylinder{0.25, 0.5}, Ellipsoid{{0.4, 0.2, 0.3}},
                              Torus{0.25, 0.1},    Cone{0.3, 0.5}};
const Shape all_kinds[] = {Sphere{0.3}, Box{{0.5, 0.4, 0.6}}};

// Bodies that fly through each other's ways, and a wall.
World swarm(Random random, int count, std::span<const Shape> shapes)
{
    std::vector<RigidBody> bodies = {fixed(Box{{3, 0.2, 3}}, {})};
    const double spread = 0.7 * std::cbrt(count);
    for (int i = 0; i < count; ++i) {
        const Shape shape = shapes[i % std::size(shapes)];
        RigidBody body = body_of(shape, spread * random.vector(), {}, random.quaternion());
        body.state.velocity = 4 * random.vector();
        spin(body, 4 * random.vector());
        bodies.push_back(body);
    }
    return world_of(std::move(bodies));
}

} // namespace

TEST_CASE("contact candidates: poses and radii are those at the start of the step", "[rigid]")
{
    const Quaternion q = turn({1, 2, 3}, 1);
    RigidBody box = body_of(Box{{2, 4, 4}}, {1, 2, 3}, {}, q);
    box.state.velocity = {1, 1, 1};
    World world = world_of({fixed(Plane{}, {}), box});
    const ContactCandidates found = candidates_of(world);
    REQUIRE(found.poses.size() == 2);
    REQUIRE(found.margins.size() == 2);
    CHECK(found.poses[1].X == Vector3d(1, 2, 3));
    CHECK(found.poses[1].R == rotation_matrix(q));
    CHECK(found.radii[0] == 0); // static
    CHECK_THAT(found.radii[1], IsClose(3.0, Rounding(4)));
    CHECK(found.margins[0] == 0);
}

TEST_CASE("contact candidates: a ball that will touch has the contact where it is now", "[rigid]")
{
    World world = row_of_balls({0.1}, 0.5); // it will have moved by twice the gap
    const ContactCandidates found = candidates_of(world);
    REQUIRE(found.contacts.size() == 1);
    const Contact& c = found.contacts[0];
    CHECK(c.body1 == 0);
    CHECK(c.body2 == 1);
    CHECK_THAT(c.gap, IsClose(0.1, Rounding(8, 1)));
    CHECK_THAT(c.normal, IsClose(Vector3d(-1, 0, 0), Rounding(4)));
    CHECK_THAT(c.point, IsClose(Vector3d(0.55, 0, 0), Rounding(4, 1)));
}

TEST_CASE("contact candidates: where nothing can meet in the step there are none", "[rigid]")
{
    World near = row_of_balls({0.3}, 0.5), far = row_of_balls({50}, 0.5);
    CHECK(candidates_of(near).contacts.empty());
    CHECK(candidates_of(far).contacts.empty());
    // If another ball does meet one of the pair, the contacts of the pair matter too.
    RigidBody third = body_of(Sphere{0.5}, {0, 1.1, 0});
    third.state.velocity = {0, -2, 0};
    near.bodies.push_back(third);
    CHECK(pairs_in(candidates_of(near)) == std::set<std::pair<int, int>>{{0, 1}, {0, 3}});
}

TEST_CASE("contact candidates: a fast body does not pass through a thin wall unseen", "[rigid]")
{
    RigidBody ball = body_of(Sphere{0.1}, {0, 0, 0});
    ball.state.velocity = {200, 0, 0}; // 20 m in a step
    World world = world_of({fixed(Box{{0.01, 2, 2}}, {}, {10, 0, 0}), ball}, {0, 0, 0});
    const ContactCandidates found = candidates_of(world);
    REQUIRE(found.contacts.size() == 1);
    CHECK_THAT(found.contacts[0].gap, IsClose(10 - 0.005 - 0.1, Rounding(4)));
}

TEST_CASE("contact candidates: a body that only rotates reaches as far as its tip moves", "[rigid]")
{
    // A rod along x that turns down by 0.2 rad, and a peg 0.15 m below its end.
    RigidBody rod = body_of(Capsule{0.1, 2}, {0, 0, 0}, {}, turn({0, 0, 1}, -std::numbers::pi / 2));
    spin(rod, {0, 0, -2});
    World world = world_of({fixed(Sphere{0.1}, {}, {1, -0.35, 0}), rod}, {0, 0, 0});
    const ContactCandidates found = candidates_of(world);
    REQUIRE(found.contacts.size() == 1);
    CHECK_THAT(found.contacts[0].gap, IsClose(0.15, Rounding(8, 1)));
}

TEST_CASE("contact candidates: a hit passes on the share of the speed that it leaves", "[rigid]")
{
    // Equal balls get (1 + ε)/2 of the speed from each other, and so the margins fall by it.
    for (const double restitution : {0.0, 0.5, 1.0}) {
        CAPTURE(restitution);
        World world = row_of_balls({1e-3, 1e-3, 1e-3}, restitution);
        const ContactCandidates found = candidates_of(world);
        double expected = 0.2; // [m]
        REQUIRE(found.margins.size() == 5);
        for (int i = 0; i < 4; ++i) {
            CHECK_THAT(found.margins[i], IsClose(expected, Rounding(16)));
            expected *= (1 + restitution) / 2;
        }
        CHECK(pairs_in(found) == std::set<std::pair<int, int>>{{0, 1}, {1, 2}, {2, 3}});
    }
}

TEST_CASE("contact candidates: a light body gets at most the whole speed of a heavy one", "[rigid]")
{
    World world = row_of_balls({1e-3, 1e-3}, 1);
    set_mass(world.bodies[0], 1e6, 1e5 * Matrix3d::Identity());
    const double m1 = world.bodies[1].mass;
    set_mass(world.bodies[2], 3 * m1, 0.3 * m1 * Matrix3d::Identity());
    const ContactCandidates found = candidates_of(world);
    CHECK_THAT(found.margins[1], IsClose(0.2, Rounding(16)));
    // The third ball gets the fraction 2 m₁ / (m₁ + 3 m₁) of this speed.
    CHECK_THAT(found.margins[2], IsClose(0.1, Rounding(16)));
}

TEST_CASE("contact candidates: a common motion changes neither margins nor contacts", "[rigid]")
{
    World world = row_of_balls({1e-3, 0.3, 1e-3}, 1);
    world.bodies.pop_back();
    const ContactCandidates rest = candidates_of(world);
    for (RigidBody& ball : world.bodies)
        ball.state.velocity += Vector3d(300, -500, 600);
    const ContactCandidates flight = candidates_of(world);
    REQUIRE(rest.contacts.size() == 2);
    CHECK(pairs_in(flight) == pairs_in(rest));
    REQUIRE(flight.margins.size() == rest.margins.size());
    for (std::size_t i = 0; i < rest.margins.size(); ++i)
        CHECK_THAT(flight.margins[i], IsClose(rest.margins[i], Rounding(8, 100)));
}

TEST_CASE("contact candidates: half a radius is always margin enough", "[rigid]")
{
    World world = row_of_balls({1e-3, 1e-3}, 1);
    world.bodies[0].state.velocity = {20, 0, 0};
    const ContactCandidates found = candidates_of(world);
    REQUIRE(found.margins.size() == 4);
    for (int i = 0; i < 3; ++i)
        CHECK(found.margins[i] == 0.25);
}

TEST_CASE("contact candidates: a hit is not passed on across a gap or by what stands still",
          "[rigid]")
{
    World row = row_of_balls({1e-3, 0.3, 1e-3}, 1);
    const ContactCandidates found = candidates_of(row);
    CHECK_THAT(found.margins[1], IsClose(0.2, Rounding(16)));
    CHECK(found.margins[2] == 0);
    CHECK(found.margins[3] == 0);

    World walled = row_of_balls({1e-3, 1e-3}, 1);
    walled.bodies[1].is_static = true;
    set_mass_from_parts(walled.bodies[1]);
    CHECK(candidates_of(walled).margins[2] == 0);

    World sleeping = row_of_balls({1e-3, 1e-3, 1e-3}, 1);
    sleeping.bodies[2].rest.group = 0; // if it is hit, it wakes up and the step is repeated
    const ContactCandidates awake = candidates_of(sleeping);
    CHECK_THAT(awake.margins[1], IsClose(0.2, Rounding(16)));
    CHECK(awake.margins[2] == 0);
    CHECK(awake.margins[3] == 0);
}

TEST_CASE("contact candidates: a sleeping body wakes if another may touch it", "[rigid]")
{
    World world = row_of_balls({0.1, 0.001}, 0.5);
    world.bodies[1].rest.group = world.bodies[2].rest.group = 0;
    const ContactCandidates hit = candidates_of(world);
    CHECK(hit.disturbed == std::vector<int>{1});
    CHECK(hit.contacts.empty()); // the step is repeated with the woken body

    world.bodies[0].state.velocity = {0.5, 0, 0}; // 0.05 m in a step do not reach it
    CHECK(candidates_of(world).disturbed.empty());
    world.bodies[0].state.velocity = {-2, 0, 0};
    world.bodies[0].state.position.x() = -0.2;
    CHECK(candidates_of(world).disturbed.empty());
}

TEST_CASE("contact candidates: static bodies and a single one meet nothing", "[rigid]")
{
    World statics = world_of({fixed(Plane{}, {}), fixed(Box{{1, 1, 1}}, {})}),
          single = world_of({body_of(Sphere{0.5}, {0, 0, 0})});
    CHECK(candidates_of(statics).contacts.empty());
    CHECK(candidates_of(single).contacts.empty());
    CHECK(statics.counters.pairs_tested == 0);
}

TEST_CASE("contact candidates: a step that takes no time finds what touches already", "[rigid]")
{
    World apart = row_of_balls({1e-6}, 0.5), overlapping = row_of_balls({-1e-6}, 0.5);
    CHECK(candidates_of(apart, 0).contacts.empty());
    CHECK(pairs_in(candidates_of(overlapping, 0)) == std::set<std::pair<int, int>>{{0, 1}});
}

TEST_CASE("contact candidates: bodies that overlap at the end of the step are among them",
          "[rigid]")
{
    std::size_t met = 0;
    for (Random random : seeds(20)) {
        World world = swarm(random, 30, round_shapes);
        const std::set<std::pair<int, int>> found = pairs_in(candidates_of(world));
        std::vector<Pose> after;
        for (const RigidBody& body : world.bodies) {
            Counters uncounted;
            after.push_back(pose_of(body.is_static
                                        ? body.state
                                        : fly(world.settings, body, body.state, tenth, uncounted)));
        }
        const int n = static_cast<int>(world.bodies.size());
        for (int i = 0; i < n; ++i)
            for (int j = i + 1; j < n; ++j) {
                std::vector<Contact> touches;
                find_contacts(world, after, i, j, 0, touches);
                if (touches.empty()) continue;
                ++met;
                CAPTURE(i, j);
                REQUIRE(found.count({i, j}) == 1);
            }
    }
    CHECK(met > 100);
}

TEST_CASE("contact candidates: any number of threads finds the same in the same order", "[rigid]")
{
    World world = swarm(3, 1500, all_kinds);
    World other = world;
    const ContactCandidates one = candidates_of(world);
    REQUIRE(one.contacts.size() > 2000);
    for (const int threads : {2, 3}) {
        CAPTURE(threads);
        World again = other;
        const ContactCandidates more = candidates_of(again, tenth, threads);
        REQUIRE(more.contacts.size() == one.contacts.size());
        for (std::size_t i = 0; i < one.contacts.size(); ++i) {
            const Contact &a = one.contacts[i], &b = more.contacts[i];
            REQUIRE((a.body1 == b.body1 && a.body2 == b.body2 && a.point == b.point &&
                     a.normal == b.normal && a.gap == b.gap));
        }
        CHECK(more.margins == one.margins);
        CHECK(more.radii == one.radii);
        CHECK(again.counters.pairs_tested == world.counters.pairs_tested);
    }
}
