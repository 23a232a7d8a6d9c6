// SPDX-License-Identifier: MIT
#include "rigid/step/bounced_flight.hpp"

#include "framework/rigid/worlds.hpp"
#include "rigid/contact/collisions.hpp"
#include "rigid/contact/make_problem.hpp"
#include "rigid/detection/contact_candidates.hpp"
#include "rigid/motion/forces.hpp"
#include "rigid/motion/free_flight.hpp"
#include "support/catch.hpp"
#include "support/close.hpp"

namespace bounced_flight_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 0.01, k = 50, r = 0.1;

// A ball that is about to hit the ground, without gravity, on a spring of no length.
World sprung_ball(double restitution, double speed)
{
    RigidBody ball = body_of(Sphere{r}, {0, r, 0}, {restitution, 0});
    set_mass(ball, 1, 0.4 * r * r * Matrix3d::Identity());
    ball.state.velocity = {0, -speed, 0};
    World world = world_of({fixed(Plane{}, {restitution, 0}), ball}, {0, 0, 0});
    world.settings.formulas_are_reference = true;
    world.springs = {{-1, 1, {0, 0, 0}, {0, 0, 0}, k, 0, 0}};
    return world;
}

struct Collided {
    std::vector<bool> pulled;
    ContactProblem problem;

    explicit Collided(World& world)
    {
        pulled = pulled_bodies(world, h);
        const auto flown = fly_all(world, pulled, h, world.pool);
        const ContactCandidates candidates = contact_candidates(world, flown, h, world.pool);
        problem = make_problem(world, flown, candidates, h, world.pool);
        process_collisions(problem);
    }
};

} // namespace

TEST_CASE("bounced flight: a ball on a spring flies on with its velocity after the bounce",
          "[rigid]")
{
    World world = sprung_ball(0.5, 2);
    Collided collided(world);
    {
        const BouncedFlight bounced(world, collided.problem, collided.pulled);
        REQUIRE_FALSE(bounced.is_empty());
        REQUIRE(bounced.bodies() == std::vector<bool>{false, true});
        REQUIRE(world.bodies[1].state.velocity.y() == 1);
        // y = r cos ωt + v/ω sin ωt
        const double w = std::sqrt(k);
        const RigidState& end = bounced.flown()[1];
        CHECK_THAT(end.position.y(),
                   IsClose(r * std::cos(w * h) + std::sin(w * h) / w, Order(1e-9)));
        CHECK_THAT(end.velocity.y(),
                   IsClose(std::cos(w * h) - r * w * std::sin(w * h), Order(1e-7)));
        // The contact stage predicts the gap with the velocity at the end, and is told the truth.
        const ContactConstraint& c = collided.problem.contacts[0];
        const double v_n = std::abs(c.normal.y()) * end.velocity.y();
        CHECK_THAT(collided.problem.predicted_gap(c, v_n),
                   IsClose(end.position.y() - r, Order(1e-9)));
    }
    CHECK(world.bodies[1].state.velocity.y() == -2); // as before
}

TEST_CASE("bounced flight: without a bounce or a force nothing flies again", "[rigid]")
{
    World rests = sprung_ball(0.5, 0), free = sprung_ball(0.5, 2);
    free.springs.clear();
    for (World* world : {&rests, &free}) {
        Collided collided(*world);
        const BouncedFlight bounced(*world, collided.problem, collided.pulled);
        CHECK(bounced.is_empty());
        CHECK(bounced.bodies().empty());
    }
}

} // namespace bounced_flight_test
