// SPDX-License-Identifier: MIT
// Bodies that bounce several times in a step, off different bodies. The collisions are elastic.
// Where bodies move along a line or bounce off walls that are perpendicular to each other, the
// exact motion is known; elsewhere no body may leave its room, and no energy may be added.
#include "rigid/step/missed_contacts.hpp"

#include "framework/rigid/worlds.hpp"
#include "rigid/contact/make_problem.hpp"
#include "rigid/motion/free_flight.hpp"
#include "support/sweep.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double radius = 0.02; // the radius of the ball, and half the edge of the cube [m]
constexpr double room = 0.06;   // how far the center can move [m]
constexpr Material elastic{1, 0};

// The place of a point that is reflected at -room/2 and at room/2, and would be at x otherwise [m].
double reflected(double x)
{
    const double phase = std::fmod(x / room + 0.5, 2.0), place = phase < 0 ? phase + 2 : phase;
    return room * ((place > 1 ? 2 - place : place) - 0.5);
}

World weightless(std::vector<RigidBody> bodies)
{
    return world_of(std::move(bodies), {0, 0, 0});
}

// Two walls of the given thickness, perpendicular to d = R e_x. The space between them has the
// width `room` + 2 `radius`.
std::vector<RigidBody> two_walls(double thickness, const Quaternion& q, const Vector3d& d)
{
    const double x = room / 2 + radius + thickness / 2;
    const Box wall{{thickness, 1, 1}};
    return {fixed(wall, elastic, x * d, q), fixed(wall, elastic, -x * d, q)};
}

// A box of six walls of the given thickness, as parts of one body.
RigidBody box_of_walls(double thickness)
{
    RigidBody walls = fixed(Plane{}, elastic);
    walls.parts.clear();
    for (int k = 0; k < 6; ++k) {
        Part part;
        Vector3d size = Vector3d::Constant(1);
        size[k % 3] = thickness;
        part.shape = Box{size};
        part.position =
            (k < 3 ? 1 : -1) * (room / 2 + radius + thickness / 2) * Vector3d::Unit(k % 3);
        walls.parts.push_back(part);
    }
    return walls;
}

// The walls as bodies of their own.
std::vector<RigidBody> apart(const RigidBody& walls)
{
    std::vector<RigidBody> bodies;
    for (const Part& part : walls.parts)
        bodies.push_back(fixed(part.shape, elastic, part.position));
    return bodies;
}

RigidBody moving(const Shape& shape, const Vector3d& X, const Vector3d& V, const Quaternion& q = {})
{
    RigidBody body = body_of(shape, X, elastic, q);
    body.state.velocity = V;
    return body;
}

// Whether the step has missed a contact if the last body ends at x e_x.
bool misses_a_contact(World world, double h, double x)
{
    ThreadPool pool;
    const std::vector<bool> pulled(world.bodies.size());
    const std::vector<RigidState> flown = fly_all(world, pulled, h, pool);
    const ContactCandidates candidates = contact_candidates(world, flown, h, pool);
    std::vector<RigidState> states = flown;
    states.back().position = {x, 0, 0};
    return has_missed_contact(world, make_problem(world, flown, candidates, h, pool), candidates,
                              flown, states);
}

} // namespace

TEST_CASE("missed contacts: where a body ends beyond its margin and in another one", "[rigid]")
{
    // The ball has 1 cm to the wall at its right, and 5 cm to the one at its left.
    std::vector<RigidBody> bodies = two_walls(0.01, {}, {1, 0, 0});
    bodies.push_back(moving(Sphere{radius}, {0.02, 0, 0}, {10, 0, 0}));
    const double h = 0.006;
    CHECK(misses_a_contact(weightless(bodies), h, -0.0301));
    CHECK(misses_a_contact(weightless(bodies), h, -0.2)); // behind the wall
    CHECK_FALSE(misses_a_contact(weightless(bodies), h, -0.0299));
    CHECK_FALSE(misses_a_contact(weightless(bodies), h, 0.03));
    CHECK_FALSE(misses_a_contact(weightless({bodies[0], bodies[2]}), h, -0.0301));
    bodies[1].group = bodies[2].group = 1; // they pass through each other
    CHECK_FALSE(misses_a_contact(weightless(bodies), h, -0.0301));
}

TEST_CASE("missed contacts: in a large island, bodies that only come near do not count", "[rigid]")
{
    // A cube lies in a row of cubes, and ends beside another cube that leans towards it. Seen from
    // the start of the step, the edge of this cube may reach the other one as it turns.
    const auto is_missed = [](int cubes, double x, bool is_cached) {
        std::vector<RigidBody> bodies = {fixed(Plane{}, {0, 0}, {0, -0.5, 0})};
        bodies.push_back(body_of(Box{{1, 1, 1}}, {-1.3, 0.126, 0}, {0, 0}, turn({0, 0, 1}, 0.3)));
        spin(bodies.back(), {0, 0, -3});
        for (int i = 1; i < cubes; ++i)
            bodies.push_back(body_of(Box{{1, 1, 1}}, Vector3d(i, 0, 0), {0, 0}));
        // More cubes, far away, make the world so large that it has a pair cache.
        for (int i = 0; i < (is_cached ? 64 : 0); ++i)
            bodies.push_back(body_of(Box{{1, 1, 1}}, Vector3d(2 * i, 50, 0), {0, 0}));
        bodies.push_back(body_of(Box{{1, 1, 1}}, {0, 0, 0}, {0, 0}));
        return misses_a_contact(world_of(bodies), 1. / 60, x);
    };
    const bool is_cached = GENERATE(false, true);
    CAPTURE(is_cached);
    CHECK(is_missed(5, -0.15, is_cached));
    CHECK_FALSE(is_missed(40, -0.15, is_cached));
    CHECK(is_missed(40, -0.3, is_cached)); // they overlap
    CHECK(is_missed(40, -8, is_cached));   // the cube has passed through the other one
    CHECK_FALSE(is_missed(5, 0, is_cached));
}

TEST_CASE("missed contacts: where a body that turns far ends behind a contact", "[rigid]")
{
    // This counts although the body ends where it is after free flight: its contact may have got no
    // impulse.
    std::vector<RigidBody> bodies = two_walls(0.01, {}, {1, 0, 0});
    bodies.push_back(moving(Box{Vector3d::Constant(2 * radius)}, {0.02, 0, 0}, {10, 0, 0}));
    spin(bodies[2], {0, 0, 200});
    CHECK_FALSE(misses_a_contact(weightless(bodies), 0.003, 0.049));
    CHECK(misses_a_contact(weightless(bodies), 0.003, 0.051));
    spin(bodies[2], {0, 0, 100}); // less than half a radian
    CHECK_FALSE(misses_a_contact(weightless(bodies), 0.003, 0.051));
}

TEST_CASE("missed contacts: what bounces between two walls stays between them", "[rigid]")
{
    const double speed = GENERATE(3.0, 7.0, 12.0, 19.0, 30.0), thickness = GENERATE(0.01, 0.2);
    const double time_step = GENERATE(0.003, 0.01);
    const bool is_ball = GENERATE(true, false), is_turned = GENERATE(false, true);
    CAPTURE(speed, thickness, time_step, is_ball, is_turned);
    const Quaternion q = is_turned ? turn({1, 2, -0.7}, 0.65) : Quaternion{1, {0, 0, 0}};
    const Vector3d d = pose_of(RigidState{{0, 0, 0}, q, {0, 0, 0}, {0, 0, 0}}).R.col(0);
    const Shape shape =
        is_ball ? Shape(Sphere{radius}) : Shape(Box{Vector3d::Constant(2 * radius)});
    std::vector<RigidBody> bodies = two_walls(thickness, q, d);
    bodies.push_back(moving(shape, 0.013 * d, speed * d, q));
    World world = weightless(bodies);
    for (int i = 1; i <= 50; ++i) {
        step(world, time_step);
        CAPTURE(i);
        const double place = world.bodies[2].state.position.dot(d);
        if (is_ball)
            CHECK_THAT(place, IsClose(reflected(0.013 + speed * time_step * i), Order(1e-6)));
        else
            CHECK(std::abs(place) < room / 2 + radius);
    }
    if (is_ball)
        CHECK_THAT(world.bodies[2].state.velocity.norm(), IsClose(speed, Rounding(1 << 16)));
}

TEST_CASE("missed contacts: a ball in a box of walls moves along each axis by itself", "[rigid]")
{
    const double thickness = GENERATE(0.01, 0.1), time_step = GENERATE(0.003, 0.01);
    CAPTURE(thickness, time_step);
    Random random(3);
    for (int k = 0; k < 10; ++k) {
        const Vector3d X = 0.4 * room * random.vector(),
                       V = random.uniform(2, 20) * random.unit_vector();
        CAPTURE(k, X, V);
        std::vector<RigidBody> bodies = apart(box_of_walls(thickness));
        bodies.push_back(moving(Sphere{radius}, X, V));
        World world = weightless(bodies);
        for (int i = 1; i <= 30; ++i) {
            step(world, time_step);
            CAPTURE(i);
            for (int axis = 0; axis < 3; ++axis)
                CHECK_THAT(world.bodies.back().state.position[axis],
                           IsClose(reflected(X[axis] + V[axis] * time_step * i), Order(1e-6)));
        }
    }
}

TEST_CASE("missed contacts: tumbling bodies stay in a box of walls and win no energy", "[rigid]")
{
    const bool is_one_body = GENERATE(false, true);
    const double thickness = GENERATE(0.01, 0.1), time_step = GENERATE(0.003, 0.01);
    const auto [count, fastest] =
        GENERATE(table<int, double>({{1, 20}, {1, 50}, {2, 50}, {40, 20}}));
    const int first_shape = GENERATE(range(0, 5));
    if (count == 40 && first_shape > 0) return; // one case of 40 bodies is enough
    static Sweep sweep;
    if (!sweep.takes_next()) return;
    CAPTURE(is_one_body, thickness, time_step, count, first_shape, fastest);
    Random random(5);
    const RigidBody walls = box_of_walls(thickness);
    std::vector<RigidBody> bodies = is_one_body ? std::vector{walls} : apart(walls);
    const std::size_t first = bodies.size();
    const double a = count < 3 ? radius : radius / 8;
    for (int k = 0; k < count; ++k) {
        const int cells = count < 3 ? 2 : 4;
        const Vector3d cell(k % cells, k / cells % cells, k / cells / cells);
        const Vector3d X = count == 1 ? Vector3d::Zero()
                                      : Vector3d((cell - Vector3d::Constant(0.5 * (cells - 1))) *
                                                 (count < 3 ? 2.1 * radius : room / cells));
        const Shape shapes[] = {Box{Vector3d::Constant(a)}, Cylinder{a / 2, a}, Sphere{a / 2},
                                Capsule{a / 4, a / 2}, Box{{a / 4, a, a}}};
        bodies.push_back(moving(shapes[(k + first_shape) % 5], X,
                                random.uniform(2, fastest) * random.unit_vector(),
                                turn(random.vector(), 1)));
    }
    World world = weightless(bodies);
    const double energy = totals(world).kinetic_energy;
    for (int i = 1; i <= 30; ++i) {
        step(world, time_step);
        CAPTURE(i);
        for (std::size_t k = first; k < world.bodies.size(); ++k)
            CHECK(world.bodies[k].state.position.lpNorm<Eigen::Infinity>() < room / 2 + radius);
        CHECK(totals(world).kinetic_energy < energy * (1 + 1e-9));
    }
}

TEST_CASE("missed contacts: a light ball bounces back and forth between heavy ones", "[rigid]")
{
    // In steps of 10 ms it meets both of them in one step, in those of 0.1 ms one at a time.
    const double light = GENERATE(0.05, 0.3, 0.9);
    const auto balls_after = [&](double time_step) {
        World world = weightless({moving(Sphere{0.02}, {-0.06, 0, 0}, {5.35, 0, 0}),
                                  moving(Sphere{0.02}, {0, 0, 0}, {0, 0, 0}),
                                  moving(Sphere{0.02}, {0.07, 0, 0}, {0, 0, 0})});
        const double masses[] = {1.3, light, 3.8};
        for (int i = 0; i < 3; ++i)
            set_mass(world.bodies[i], masses[i], 1.6e-4 * masses[i] * Matrix3d::Identity());
        run(world, static_cast<int>(std::lround(0.1 / time_step)), time_step);
        return world;
    };
    const World exact = balls_after(1e-4), found = balls_after(0.01);
    CHECK_THAT(totals(found).kinetic_energy, IsClose(0.5 * 1.3 * 5.35 * 5.35, Rounding(1 << 16)));
    for (int i = 0; i < 3; ++i) {
        CAPTURE(i);
        CHECK_THAT(found.bodies[i].state.velocity.x(),
                   IsClose(exact.bodies[i].state.velocity.x(), Order(1e-6)));
    }
}

TEST_CASE("missed contacts: a ball bounces into a body that sleeps, is pulled or is driven",
          "[rigid]")
{
    const double time_step = GENERATE(0.004, 0.01), speed = GENERATE(5.0, 11.0);
    CAPTURE(time_step, speed);
    const double x = room / 2 + radius;
    const RigidBody wall = fixed(Box{{0.2, 1, 1}}, elastic, {x + 0.1, 0, 0});
    const RigidBody ball = moving(Sphere{radius}, {0.02, radius, 0}, {speed, 0, 0});
    SECTION("sleeps")
    {
        // The ball hits the sleeping cube, of its own mass, in the middle of a face.
        RigidBody cube =
            body_of(Box{Vector3d::Constant(2 * radius)}, {-x - radius, radius, 0}, elastic);
        set_mass(cube, ball.mass, cube.inertia);
        World world = world_of({fixed(Plane{}, elastic), wall, cube, ball});
        World before = world;
        before.bodies[3].state.velocity.setZero();
        for (int i = 0; i < 1000 && !before.bodies[2].rest.is_asleep(); ++i)
            step(before, time_step);
        REQUIRE(before.bodies[2].rest.is_asleep());
        before.bodies[3] = ball;
        world = before;
        run(world, static_cast<int>(std::lround(0.02 / time_step)), time_step);
        CHECK_THAT(world.bodies[2].state.velocity.x(), IsClose(-speed, Order(1e-6)));
    }
    SECTION("pulled")
    {
        // The drag is so small that it changes nothing.
        RigidBody pulled = ball;
        pulled.drag.linear = 1e-9;
        std::vector<RigidBody> bodies = two_walls(0.01, {}, {1, 0, 0});
        bodies.push_back(pulled);
        World world = weightless(bodies);
        for (int i = 1; i <= 20; ++i) {
            step(world, time_step);
            CAPTURE(i);
            CHECK(std::abs(world.bodies[2].state.position.x()) < room / 2 + 1e-4);
        }
    }
    SECTION("driven")
    {
        // A piston comes towards the ball.
        Drive drive;
        drive.velocity = {1, 0, 0};
        drive.first_position = {-x - 0.1, 0, 0};
        RigidBody piston = fixed(Box{{0.2, 1, 1}}, elastic, drive.first_position);
        piston.drive = std::make_shared<Drive>(drive);
        World world = weightless({piston, wall, ball});
        for (int i = 1; i <= 3; ++i) {
            step(world, time_step);
            CAPTURE(i);
            const double piston_face = world.bodies[0].state.position.x() + 0.1;
            CHECK(world.bodies[2].state.position.x() > piston_face + radius - 1e-4);
            CHECK(world.bodies[2].state.position.x() < room / 2 + 1e-4);
        }
    }
}

TEST_CASE("missed contacts: a ball bounces into another one that free flight would pass", "[rigid]")
{
    // The ball bounces off the wall and then meets the fixed ball, which it would have passed.
    const double time_step = GENERATE(0.01, 0.005, 0.0025), y = GENERATE(0.029, 0.031, 0.033);
    CAPTURE(time_step, y);
    std::vector<RigidBody> bodies = {fixed(Box{{0.2, 1, 1}}, elastic, {0.125, 0, 0}),
                                     fixed(Sphere{0.005}, elastic, {0.011, y, 0}),
                                     moving(Sphere{0.005}, {0, 0, 0}, {4, 4, 0})};
    const auto closest = [&](double h) {
        World world = weightless(bodies);
        double least = 1;
        for (int i = 0; i < std::lround(0.02 / h); ++i) {
            step(world, h);
            least =
                std::min(least, (world.bodies[2].state.position - Vector3d(0.011, y, 0)).norm());
        }
        return std::pair(world.bodies[2].state.velocity, least);
    };
    const auto [V, least] = closest(time_step);
    CHECK_THAT(V, IsClose(closest(1e-4).first, Order(1e-6)));
    CHECK(least > 0.01 - 1e-9);
}

TEST_CASE("missed contacts: the tip of a driven blade meets what lies at its reach", "[rigid]")
{
    const double angle = GENERATE(0.3, 0.5, 1.0, 1.5), h = 0.01; // per step [rad], [s]
    CAPTURE(angle);
    Drive drive;
    drive.angular_velocity = {0, 0, angle / h};
    drive.first_orientation = turn({0, 0, 1}, -angle / 2);
    RigidBody blade = fixed(Box{{2, 0.05, 0.05}}, elastic, {0, 0, 0}, drive.first_orientation);
    blade.drive = std::make_shared<Drive>(drive);
    World world = weightless({blade, moving(Sphere{0.005}, {0.99, 0, 0}, {0, 0, 0})});
    step(world, h);
    CHECK(world.bodies[1].state.velocity.y() > 1);
}

TEST_CASE("missed contacts: a pile beside a divided step keeps its weight", "[rigid]")
{
    // An elastic ball rattles between two high walls and divides each step. The cube beside it
    // comes to rest and falls asleep; all the time the ground carries its weight.
    std::vector<RigidBody> bodies = {fixed(Plane{}, {0, 0.5})};
    const double x = room / 2 + radius + 0.1;
    for (const double side : {-x, x})
        bodies.push_back(fixed(Box{{0.2, 60, 1}}, elastic, {side, 30, 0}));
    bodies.push_back(body_of(Box{{1, 1, 1}}, {3, 0.5, 0}, {0, 0.5}));
    bodies.push_back(moving(Sphere{radius}, {0.01, 50, 0}, {25, 0, 0}));
    World world = world_of(bodies);
    const double h = 0.01, weight = bodies[3].mass * g;
    for (std::uint64_t i = 1; i <= 150; ++i) {
        CAPTURE(i);
        double carried = 0;
        for (const ContactRecord& record : step(world, h))
            if (record.body1 == 3 || record.body2 == 3) carried += std::abs(record.impulse.y());
        CHECK_THAT(carried / h, IsClose(weight, Rounding(1e6)));
        CHECK(world.counters.steps == i);
        CHECK(std::abs(world.bodies[4].state.position.x()) < room / 2 + 1e-3);
    }
    CHECK(world.bodies[3].rest.is_asleep());
}
