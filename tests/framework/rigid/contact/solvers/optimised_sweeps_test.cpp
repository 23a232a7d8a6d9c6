// SPDX-License-Identifier: MIT
#include "rigid/contact/solvers/optimised_sweeps.hpp"

#include "framework/rigid/contact/solvers/sweep_laws.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr auto optimised_of = [](HandMade& problem, std::span<const int> active) {
    return optimised_sweeps(problem, problem.island, active);
};
constexpr auto optimised_of_pile = [](Pile& pile) { return optimised_of(pile, pile.active); };

} // namespace

TEST_CASE("optimised sweeps: n of them are n sweeps of resolve_simultaneously", "[rigid]")
{
    check_sweeps_are_those_of_the_formula(optimised_of_pile);
}

TEST_CASE("optimised sweeps: impulses that are added act on the bodies", "[rigid]")
{
    check_added_impulses_act_on_the_bodies(optimised_of_pile);
}

TEST_CASE("optimised sweeps: one sweep stops a single body", "[rigid]")
{
    check_progress_of_a_single_contact(optimised_of);
}

TEST_CASE("optimised sweeps: without approach or contacts nothing changes", "[rigid]")
{
    check_sweeps_without_work(optimised_of);
}

TEST_CASE("optimised sweeps: a world of boxes moves as by the readable formulas", "[rigid]")
{
    std::vector<RigidBody> bodies = {fixed(Plane{}, {0.2, 0.5})};
    Random random(4);
    for (int i = 0; i < 6; ++i)
        bodies.push_back(body_of(Box{{0.4, 0.3, 0.5}}, Vector3d(0.9 * i, 0.4, 0), {0.2, 0.5},
                                 random.quaternion()));
    World fast = world_of(bodies), readable = fast;
    fast.settings.formulas_are_reference = true;
    run(fast, 60, 0.01);
    run(readable, 60, 0.01);
    REQUIRE(fast.counters.contact_impulses > 100);
    for (std::size_t i = 1; i < bodies.size(); ++i)
        CHECK_THAT(fast.bodies[i].state.position,
                   IsClose(readable.bodies[i].state.position, Rounding(1e4, 1)));
}
