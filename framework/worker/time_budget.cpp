// SPDX-License-Identifier: MIT
#include "worker/time_budget.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

namespace {

// If the answered calls of one formula have taken more than this share of the budget of all calls,
// the time of each further call is compared with the time of the reference. So a slow formula
// leaves some of the budget for the other ones. Without a reference, one formula may use the whole
// budget.
constexpr double share_with_reference = 0.25;

} // namespace

TimeBudget::TimeBudget(const Limits& limits, bool has_reference)
    : limits_(limits), has_reference_(has_reference)
{
}

void TimeBudget::go_on_from(const Spent& spent)
{
    calls_ = spent.calls;
    scenes_ = spent.scenes;
    starts_ = spent.starts;
    for (const FormulaIndex formula : spent.given_up)
        of(formula).was_given_up = true;
}

void TimeBudget::begin_again(Seconds budget)
{
    limits_.all_calls = limits_.all_scenes = budget;
    rows_ = {};
    calls_ = scenes_ = starts_ = on_processor_ = {};
    is_begun_again_ = true;
}

void TimeBudget::returned(FormulaIndex formula, Seconds took)
{
    calls_ += took;
    of(formula).answered += took;
}

void TimeBudget::failed(FormulaIndex formula, Seconds took, bool timed_out)
{
    calls_ += took;
    of(formula).lost += took;
    if (timed_out) ++of(formula).timeouts;
}

bool TimeBudget::is_compared(FormulaIndex formula) const
{
    const double share = has_reference_ ? share_with_reference : 1;
    return of(formula).answered > share * floor_factor() * limits_.all_calls;
}

void TimeBudget::compare(FormulaIndex formula, Seconds took, Seconds reference_took)
{
    of(formula).compared += took;
    of(formula).by_reference += reference_took;
}

bool TimeBudget::is_too_slow(const Row& row) const
{
    if (is_begun_again_)
        return row.answered > limits_.all_calls && on_processor_ > limits_.all_calls;
    return row.compared > limits_.call / 10 + limits_.multiple * row.by_reference;
}

TimeBudget::Seconds TimeBudget::limit_of_start() const
{
    return std::clamp(limits_.all_starts - starts_, std::min(limits_.late_start, limits_.start),
                      limits_.start);
}

std::string TimeBudget::why_start_ended(Seconds limit) const
{
    std::string text = fmt::format("took longer than {:.3g} s", limit.count());
    if (limit < limits_.start)
        text += fmt::format(" (all starts together may take {:.3g} s)", limits_.all_starts.count());
    return text + " before any function is called: look at what it defines globally, such as a "
                  "variable with a constructor";
}

bool TimeBudget::is_given_up(FormulaIndex formula) const
{
    const Row& row = of(formula);
    return row.was_given_up || row.timeouts >= (calls_are_used_up() ? 1 : 2) ||
           row.lost > 2 * floor_of_call() || is_too_slow(row);
}

std::string TimeBudget::why_given_up(FormulaIndex formula) const
{
    const Row& row = of(formula);
    if (row.was_given_up) return "was given up in an earlier run, so it is not asked again";
    if (row.timeouts >= 2) return "did not return twice, so it is not asked again";
    if (row.timeouts == 1 && calls_are_used_up())
        return "did not return, so it is not asked again: the time for all calls is used up";
    if (row.lost > 2 * floor_of_call())
        return fmt::format(
            "ended without an answer after {:.3g} s in all, so it is not asked again",
            row.lost.count());
    return fmt::format("is not asked any more: its calls took {:.3g} s{}", row.answered.count(),
                       has_reference_ ? fmt::format(", where the reference took {:.2g} s for the "
                                                    "last {:.3g} s of them",
                                                    row.by_reference.count(), row.compared.count())
                                      : "");
}

bool TimeBudget::ends_scenes(FormulaIndex formula) const
{
    return of(formula).failed_scenes >= 2 && is_given_up(formula);
}

TimeBudget::Seconds TimeBudget::floor_of_wait(FormulaIndex formula) const
{
    const bool is_short = is_given_up(formula) || scenes_are_used_up();
    return is_short ? limits_.call / 10 : floor_of_call();
}

TimeBudget::Seconds TimeBudget::floor_of_scene() const
{
    // A reference tells how long each scene may take. The floor then matters for short scenes only.
    const Seconds floor = has_reference_ ? std::min(limits_.call, limits_.scene) : limits_.scene;
    return scenes_are_used_up() ? floor / 10 : floor;
}

Spent TimeBudget::spent() const
{
    Spent spent{calls_, scenes_, starts_, {}};
    for (unsigned i = 0; i < formula_count; ++i)
        if (is_given_up(FormulaIndex{i})) spent.given_up.push_back(FormulaIndex{i});
    return spent;
}

std::string TimeBudget::report() const
{
    std::vector<std::string> parts;
    std::string names;
    for (const FormulaIndex formula : spent().given_up)
        names += fmt::format("{}{}", names.empty() ? "" : ", ",
                             formulas[static_cast<unsigned>(formula)].name);
    if (!names.empty()) parts.push_back("not asked any more: " + names);
    const auto add = [&](const char* what, Seconds used, Seconds free) {
        if (used > free)
            parts.push_back(fmt::format("{} took {:.3g} s, of which {:.3g} s are free", what,
                                        used.count(), free.count()));
    };
    add("all calls together", calls_, limits_.all_calls);
    add("all scenes together", scenes_, limits_.all_scenes);
    add("all starts of the program together", starts_, limits_.all_starts);
    return fmt::format("{}", fmt::join(parts, "; "));
}

} // namespace rigor
