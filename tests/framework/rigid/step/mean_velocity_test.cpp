// SPDX-License-Identifier: MIT
#include "rigid/step/mean_velocity.hpp"

#include "framework/rigid/worlds.hpp"
#include "geometry/meshes/generators.hpp"
#include "rigid/contact/collisions.hpp"
#include "rigid/contact/make_problem.hpp"
#include "rigid/contact/resting_contact.hpp"
#include "rigid/motion/free_flight.hpp"

#include <algorithm>
#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace mean_velocity_test {

namespace {

constexpr double h = 0.01; // the time step [s]
const Material smooth{0, 0};

// The contact problem of a step up to the contact stage, and which islands move by mean velocities.
struct Solved {
    std::vector<RigidState> flown;
    ContactCandidates candidates;
    ContactProblem problem;
    std::vector<Body> after_collisions;
    std::vector<char> by_mean;

    explicit Solved(World& world)
    {
        world.settings.formulas_are_reference = true;
        const std::vector<bool> pulled(world.bodies.size(), false);
        flown = fly_all(world, pulled, h, world.pool);
        candidates = contact_candidates(world, flown, h, world.pool);
        problem = make_problem(world, flown, candidates, h, world.pool);
        process_collisions(problem);
        after_collisions = problem.bodies;
        for (const Island& island : problem.islands)
            for (const int i : island.bodies)
                problem.bodies[i] = with_forces(problem.bodies[i], world.bodies[i].state, flown[i]);
        for (const Island& island : problem.islands)
            process_contact(problem, island, after_collisions);
        by_mean =
            solve_again_at_midpoint(world, after_collisions, flown, candidates.poses, problem);
    }
};

// A ball that slides over the top of a fixed shape.
World sliding_over(const Shape& shape, double speed)
{
    RigidBody ball = body_of(Sphere{0.1}, {0, 1.1, 0}, smooth);
    ball.state.velocity = {speed, 0, 0};
    return world_of({fixed(shape, smooth), ball});
}

} // namespace

TEST_CASE("mean velocity: the impulse over a curve is that of its middle", "[rigid]")
{
    const double speed = GENERATE(0.1, 1.0, 2.0);
    CAPTURE(speed);
    World world = sliding_over(Sphere{1}, speed);
    Solved solved(world);
    REQUIRE(solved.by_mean == std::vector<char>{true});
    const Body &first = solved.after_collisions[1], &last = solved.problem.bodies[1];
    const ContactConstraint& c = solved.problem.contacts[0];
    // In the middle of the step the ball has gone on by h v/2 = (R + r) tan θ, with the angle θ of
    // the contact's normal.
    const Vector3d up = -c.normal; // from the fixed ball, which is body 1, to the one that slides
    CHECK_THAT(up.x(), IsClose(h * speed / 2 / std::hypot(1.1, h * speed / 2), Order(1e-9)));
    CHECK_THAT((first.velocity + last.velocity).dot(c.normal), IsClose(0.0, Rounding(256, speed)));
    const Vector3d impulse =
        world.bodies[1].mass * (last.velocity - first.velocity - h * world.settings.gravity);
    CHECK_THAT(impulse,
               IsClose(Vector3d(-c.contact_impulse), Rounding(64, world.bodies[1].mass * speed)));
}

TEST_CASE("mean velocity: a ball that is too fast for a curve leaves it", "[rigid]")
{
    World world = sliding_over(Sphere{1}, 4); // v² > g (R + r)
    Solved solved(world);
    REQUIRE(solved.by_mean == std::vector<char>{true});
    CHECK(solved.problem.contacts[0].contact_impulse.isZero(0));
    CHECK_THAT(solved.problem.bodies[1].velocity, IsClose(Vector3d(4, -g * h, 0), Rounding(64)));
}

TEST_CASE("mean velocity: along a plane it takes the contacts of the start", "[rigid]")
{
    World world = world_of({fixed(Plane{}, smooth), body_of(Sphere{0.1}, {0, 0.1, 0}, smooth)});
    world.bodies[1].state.velocity = {1, 0, 0};
    Solved solved(world);
    CHECK(solved.by_mean == std::vector<char>{true});
    CHECK(solved.problem.contacts[0].normal == -Vector3d::UnitY());
}

TEST_CASE("mean velocity: a ball that hits a curve moves by its last velocity", "[rigid]")
{
    World world = sliding_over(Sphere{1}, 1);
    world.bodies[1].state.velocity.y() = -1;
    Solved solved(world);
    CHECK(solved.by_mean == std::vector<char>{false});
}

TEST_CASE("mean velocity: integrators of the first order have none", "[rigid]")
{
    World world = sliding_over(Sphere{1}, 1);
    world.settings.integrator =
        GENERATE(Integrator::linear, Integrator::exponential, Integrator::buss,
                 Integrator::gram_schmidt, Integrator::euler_angles);
    Solved solved(world);
    CHECK(solved.by_mean == std::vector<char>{false});
}

TEST_CASE("mean velocity: a curve of a mesh takes the contacts of the start", "[rigid]")
{
    World world = sliding_over(mesh_of(icosphere(1, 3)), 1);
    world.bodies[1].state.position.y() = 1.1;
    Solved solved(world);
    for (const ContactConstraint& c : solved.problem.contacts) {
        const auto same = [&](const Contact& start) { return start.normal == c.normal; };
        const std::vector<Contact>& starts = solved.candidates.contacts;
        CHECK(std::any_of(starts.begin(), starts.end(), same));
    }
}

} // namespace mean_velocity_test
