// SPDX-License-Identifier: MIT
// What a formula that does not return costs, and what it leaves to the others.
#include "worker/time_budget.hpp"

#include "attack.hpp"
#include "support/catch.hpp"

namespace rigor {

namespace {

constexpr FormulaIndex one = FormulaIndex::multiply, other = FormulaIndex::rotate;

Limits limits_of_seconds()
{
    Limits limits;
    limits.call = Seconds(2);
    limits.all_calls = Seconds(8);
    limits.all_scenes = Seconds(20);
    limits.multiple = 50;
    return limits;
}

} // namespace

TEST_CASE("time budget: two timeouts give a formula up and no other one")
{
    TimeBudget budget(limits_of_seconds(), true);
    budget.failed(one, Seconds(2), true);
    REQUIRE_FALSE(budget.is_given_up(one));
    budget.failed(one, Seconds(2), true);
    REQUIRE(budget.is_given_up(one));
    REQUIRE_FALSE(budget.is_given_up(other));
    REQUIRE(budget.report() == "not asked any more: multiply");
}

TEST_CASE("time budget: when the free time is used up one short timeout is enough")
{
    TimeBudget budget(limits_of_seconds(), true);
    for (const FormulaIndex formula :
         {FormulaIndex::multiply, FormulaIndex::rotate, FormulaIndex::to_matrix})
        for (int i = 0; i < 2; ++i)
            budget.failed(formula, Seconds(2), true);
    REQUIRE(budget.floor_of_call() == Seconds(0.2));
    const FormulaIndex next = FormulaIndex::quaternion_rate;
    REQUIRE_FALSE(budget.is_given_up(next));
    budget.failed(next, Seconds(0.2), true);
    REQUIRE(budget.is_given_up(next));
}

TEST_CASE("time budget: a crash is asked again unless it takes as long as an endless loop")
{
    TimeBudget budget(limits_of_seconds(), true);
    for (int i = 0; i < 1000; ++i)
        budget.failed(one, Seconds(0.001), false);
    REQUIRE_FALSE(budget.is_given_up(one));
    for (int i = 0; i < 3; ++i)
        budget.failed(other, Seconds(1.5), false); // as by hoarding memory
    REQUIRE(budget.is_given_up(other));
}

TEST_CASE("time budget: a slow formula may take the usual multiple of the reference")
{
    TimeBudget right(limits_of_seconds(), true), wrong(limits_of_seconds(), true);
    for (int i = 0; i < 1000; ++i) {
        for (TimeBudget* budget : {&right, &wrong}) {
            budget->returned(one, Seconds(0.1));
            const Seconds by_reference(budget == &right ? 0.1 / 49 : 0.1 / 51);
            if (budget->is_compared(one)) budget->compare(one, Seconds(0.1), by_reference);
        }
        REQUIRE_FALSE(right.is_given_up(one));
    }
    REQUIRE(right.is_compared(one));
    REQUIRE(wrong.is_given_up(one));
    REQUIRE_FALSE(wrong.is_compared(other));
    REQUIRE_FALSE(wrong.is_given_up(other));
}

TEST_CASE("time budget: a formula that was given up has two short chances in scenes")
{
    TimeBudget budget(limits_of_seconds(), true);
    for (int i = 0; i < 2; ++i)
        budget.failed(one, Seconds(2), true);
    REQUIRE(budget.floor_of_wait(one) == Seconds(0.2));
    REQUIRE(budget.floor_of_wait(other) == Seconds(2));
    REQUIRE_FALSE(budget.ends_scenes(one));
    for (int i = 0; i < 2; ++i)
        budget.scene_failed(one);
    REQUIRE(budget.ends_scenes(one));
    for (int i = 0; i < 2; ++i)
        budget.scene_failed(other); // it answers outside of scenes
    REQUIRE_FALSE(budget.ends_scenes(other));
}

TEST_CASE("time budget: a later run goes on from it")
{
    TimeBudget first(limits_of_seconds(), true), second(limits_of_seconds(), true);
    for (const FormulaIndex formula : {one, other, FormulaIndex::to_matrix})
        for (int i = 0; i < 2; ++i)
            first.failed(formula, Seconds(2), true);
    first.waited_in_scene(Seconds(21));
    second.go_on_from(first.spent());
    REQUIRE(second.is_given_up(one));
    REQUIRE(second.floor_of_call() == Seconds(0.2));
    REQUIRE(second.floor_of_scene() == first.floor_of_scene());
    REQUIRE(second.why_given_up(one) == "was given up in an earlier run, so it is not asked again");
    REQUIRE_FALSE(second.is_given_up(FormulaIndex::conjugate));
}

TEST_CASE("time budget: one that is begun again has forgotten what was spent")
{
    TimeBudget budget(limits_of_seconds(), true);
    for (int i = 0; i < 4; ++i)
        budget.failed(one, Seconds(2), true);
    budget.waited_in_scene(Seconds(21));
    budget.returned(other, Seconds(1));
    budget.begin_again(Seconds(5));
    REQUIRE_FALSE(budget.is_given_up(one));
    REQUIRE(budget.report().empty());
    budget.returned(one, Seconds(5));
    REQUIRE(budget.floor_of_call() == Seconds(2));
    budget.returned(one, Seconds(0.5));
    REQUIRE(budget.report() == "all calls together took 5.5 s, of which 5 s are free");
}

TEST_CASE("time budget: one that is begun again counts late replies by the processor's time")
{
    TimeBudget budget(limits_of_seconds(), false);
    budget.begin_again(Seconds(5));
    budget.returned(one, Seconds(12));
    REQUIRE(budget.is_compared(one));
    budget.compare(one, Seconds(7), Seconds(0));
    budget.ran(Seconds(4.9));
    REQUIRE_FALSE(budget.is_given_up(one));
    budget.ran(Seconds(5.1));
    REQUIRE(budget.is_given_up(one));
    REQUIRE_FALSE(budget.is_given_up(other));
}

TEST_CASE("time budget: all starts together have a budget, and late ones must be fast")
{
    Limits limits = limits_of_seconds();
    limits.start = limits.all_starts = Seconds(10);
    limits.late_start = Seconds(0.05);
    TimeBudget budget(limits, true), later(limits, true);
    REQUIRE(budget.limit_of_start() == Seconds(10));
    for (int i = 0; i < 6; ++i)
        budget.started(Seconds(1.5));
    REQUIRE(budget.limit_of_start() == Seconds(1));
    REQUIRE_FALSE(budget.starts_are_used_up());
    budget.started(Seconds(1.125));
    REQUIRE(budget.limit_of_start() == Seconds(0.05));
    REQUIRE(budget.floor_of_call() == Seconds(2));
    REQUIRE(budget.report() == "all starts of the program together took 10.1 s, of which 10 s are "
                               "free");
    later.go_on_from(budget.spent());
    REQUIRE(later.starts_are_used_up());
    budget.begin_again(Seconds(5));
    REQUIRE(budget.limit_of_start() == Seconds(10));
}

TEST_CASE("time budget: what is used up is told")
{
    TimeBudget budget(limits_of_seconds(), true);
    REQUIRE(budget.report().empty());
    budget.returned(one, Seconds(8.5));
    budget.waited_in_scene(Seconds(20.5));
    REQUIRE(budget.report() == "all calls together took 8.5 s, of which 8 s are free; "
                               "all scenes together took 20.5 s, of which 20 s are free");
}

} // namespace rigor
