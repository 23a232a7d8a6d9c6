// SPDX-License-Identifier: MIT
#include "rigid/step/supported_flight.hpp"

#include "framework/rigid/worlds.hpp"
#include "rigid/contact/collisions.hpp"
#include "rigid/contact/make_problem.hpp"
#include "rigid/contact/resting_contact.hpp"
#include "rigid/detection/contact_candidates.hpp"
#include "rigid/motion/forces.hpp"
#include "rigid/motion/free_flight.hpp"
#include "rigid/step/velocity_update.hpp"
#include "support/catch.hpp"
#include "support/close.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 0.01;

// A block on the ground, with a spring and a damper to a fixed point above it.
World block_on_a_damper(double damping)
{
    RigidBody block = body_of(Box{{1, 1, 1}}, {0, 0.5, 0}, {0, 0.5});
    set_mass(block, 2, block.inertia * (2 / block.mass));
    World world = world_of({fixed(Plane{}, {0, 0.5}), block});
    world.settings.formulas_are_reference = true;
    world.springs = {{-1, 1, {0, 3, 0}, {0, 0, 0}, 10, damping, 2.4}};
    return world;
}

// The step of a world up to the contact stage.
struct Solved {
    std::vector<bool> pulled;
    std::vector<RigidState> flown;
    ContactProblem problem;
    std::vector<Body> first;

    explicit Solved(World& world)
    {
        pulled = pulled_bodies(world, h);
        flown = fly_all(world, pulled, h, world.pool);
        const ContactCandidates candidates = contact_candidates(world, flown, h, world.pool);
        problem = make_problem(world, flown, candidates, h, world.pool);
        process_collisions(problem);
        first = problem.bodies;
        for (const Island& island : problem.islands) {
            apply_forces(world, island, first, flown, problem);
            process_contact(problem, island, first);
        }
    }
    bool is_too_long(const World& world)
    {
        return is_too_long_for_friction(world, problem, pulled);
    }
    std::optional<SupportedFlight> fly(World& world)
    {
        return fly_supported(world, problem, first, pulled, flown);
    }
};

} // namespace

TEST_CASE("supported flight: a body that the ground holds stays where it is", "[rigid]")
{
    for (const double damping : {0., 5., 300.}) {
        CAPTURE(damping);
        World world = block_on_a_damper(damping);
        Solved solved(world);
        CHECK(solved.flown[1].velocity.y() < -1e-3); // it falls in free flight
        const std::optional<SupportedFlight> flight = solved.fly(world);
        REQUIRE(flight.has_value());
        // The loads have errors of a share of 1e-8.
        CHECK_THAT(flight->flown[1].velocity.norm(), IsClose(0.0, Order(1e-8 * g * h)));
        CHECK_THAT(flight->flown[1].position,
                   IsClose(Vector3d(0, 0.5, 0), Order(1e-8 * g * h * h)));
        // The ground bears the weight and what the spring presses with.
        double load = 0;
        for (const ContactConstraint& c : solved.problem.contacts)
            load += (c.body1 == 1 ? 1 : -1) * c.contact_impulse.y();
        CHECK_THAT(load / h, IsClose(2 * g - 10 * 0.1, Order(1e-6)));
        CHECK_THAT(flight->forced[1].velocity.y(), IsClose(-load / 2, Order(1e-8)));
    }
}

TEST_CASE("supported flight: without forces besides gravity there is none", "[rigid]")
{
    World world = block_on_a_damper(5);
    world.springs.clear();
    CHECK_FALSE(Solved(world).fly(world).has_value());
}

TEST_CASE("supported flight: a step may be too long for friction", "[rigid]")
{
    World world = block_on_a_damper(0);
    CHECK_FALSE(Solved(world).is_too_long(world));
    world.springs[0].stiffness = 1e6;
    world.springs[0].rest_length = 2.5;
    CHECK(Solved(world).is_too_long(world)); // the angular frequency is 707 1/s
    for (RigidBody& body : world.bodies)
        body.material.friction = 0;
    CHECK_FALSE(Solved(world).is_too_long(world));
}
