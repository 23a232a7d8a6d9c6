// SPDX-License-Identifier: MIT
#include "rigid/contact/make_problem.hpp"

#include "framework/rigid/worlds.hpp"
#include "rigid/motion/free_flight.hpp"

namespace make_problem_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 0.01; // [s]

ContactProblem problem_of(World& world, ThreadPool& pool)
{
    const std::vector<bool> pulled(world.bodies.size(), false);
    const std::vector<RigidState> flown = fly_all(world, pulled, h, pool);
    return make_problem(world, flown, contact_candidates(world, flown, h, pool), h, pool);
}

} // namespace

TEST_CASE("contact problem: a contact combines the materials and the speeds of its bodies",
          "[rigid]")
{
    ThreadPool alone;
    RigidBody ball = body_of(Sphere{1}, {0, 1, 0}, {0.5, 0.4});
    ball.state.velocity = {0, -2, 0};
    World world = world_of({fixed(Plane{}, {0.2, 0.9}), ball});
    const ContactProblem problem = problem_of(world, alone);
    REQUIRE(problem.contacts.size() == 1);
    const ContactConstraint& c = problem.contacts[0];
    CHECK(c.restitution == 0.2);                                 // the smaller one
    CHECK_THAT(c.friction, IsClose(0.6, Rounding(4)));           // the geometric mean
    CHECK_THAT(c.force_speed, IsClose(-g * h, Rounding(16, 2))); // by gravity in this step
    CHECK_THAT(c.free_speed, IsClose(-2 - g * h, Rounding(16)));
    CHECK_THAT(c.normal_K, IsClose(1 / ball.mass, Rounding(16)));
    CHECK(c.radius == 1);
    REQUIRE(problem.islands.size() == 1);
    CHECK(problem.islands[0].bodies == std::vector<int>{1});
}

TEST_CASE("contact problem: what does not meet in the step has no contact", "[rigid]")
{
    ThreadPool alone;
    RigidBody ball = body_of(Sphere{1}, {0, 1.1, 0});
    ball.state.velocity = {0, 5, 0};
    World world = world_of({fixed(Plane{}, {}), ball});
    CHECK(problem_of(world, alone).islands.empty());
}

} // namespace make_problem_test
