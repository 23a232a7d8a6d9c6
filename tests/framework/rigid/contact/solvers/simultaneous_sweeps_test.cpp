// SPDX-License-Identifier: MIT
#include "rigid/contact/solvers/simultaneous_sweeps.hpp"

#include "framework/rigid/contact/solvers/sweep_laws.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr auto by_formula = [](ContactProblem& problem, std::span<const int> active) {
    return simultaneous_sweeps(problem, active);
};
constexpr auto pile_by_formula = [](Pile& pile) { return simultaneous_sweeps(pile, pile.active); };

} // namespace

TEST_CASE("simultaneous sweeps: n of them are n sweeps of resolve_simultaneously", "[rigid]")
{
    check_sweeps_are_those_of_the_formula(pile_by_formula);
}

TEST_CASE("simultaneous sweeps: one of them has the bits of the formula", "[rigid]")
{
    for (Random random : seeds(20)) {
        Pile pile(random);
        const ContactResult expected = resolve_simultaneously(pile.bodies, pile.for_formula(), 1);
        const std::unique_ptr<Sweeps> sweeps = simultaneous_sweeps(pile, pile.active);
        std::vector<Vector3d> steps(pile.active.size());
        sweeps->sweep(steps);
        sweeps->finish();
        pile.check_result(expected, Exactly());
    }
}

TEST_CASE("simultaneous sweeps: impulses that are added act on the bodies", "[rigid]")
{
    check_added_impulses_act_on_the_bodies(pile_by_formula);
}

TEST_CASE("simultaneous sweeps: one sweep stops a single body", "[rigid]")
{
    check_progress_of_a_single_contact(by_formula);
}

TEST_CASE("simultaneous sweeps: without approach or contacts nothing changes", "[rigid]")
{
    check_sweeps_without_work(by_formula);
}
