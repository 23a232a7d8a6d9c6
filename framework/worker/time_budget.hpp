// SPDX-License-Identifier: MIT
// Limits the time of all requests of one submission together. A formula is given up if it twice did
// not return in time, if its calls without an answer took too long together, or if it is far slower
// than the reference. Tests do not call such a formula any more, and scenes only until it has
// failed in two of them. So an endless loop costs only seconds, however many tests and other
// formulas call it. Time counts as in `Limits` in process.hpp: while the worker is on a processor,
// or asleep while the client waits.
//
// All calls together have a budget of time, and so have all scenes (`Limits::all_calls` and
// `all_scenes`). When it is used up, the floor (the lowest time limit) of a call or a scene is only
// a tenth of its usual value. When the budget of the calls is used up, a formula is given up after
// one call that does not return in time. The limit is this floor or `Limits::multiple` times the
// time of the reference, whichever is longer. So a solution that is slow and right is graded to its
// end, and a solution that does not return is soon given up.
//
// All starts of the worker together have a budget too (`Limits::all_starts`). A start constructs
// the global objects of a submission, and the worker starts again for each task and after each test
// case that failed. When this budget is used up, a start must be as fast as `Limits::late_start`.
#pragma once

#include "formulas/table.hpp"
#include "worker/process.hpp"

#include <array>
#include <string>

namespace rigor {

/// What a submission has cost so far. A later run of the same submission starts from it.
struct Spent {
    std::chrono::duration<double> calls{}, scenes{}, starts{};
    std::vector<FormulaIndex> given_up;
};

class TimeBudget {
public:
    using Seconds = std::chrono::duration<double>;

    /// @param has_reference  whether there is a reference to compare with
    TimeBudget(const Limits& limits, bool has_reference);

    /// Goes on from what an earlier run has spent.
    void go_on_from(const Spent& spent);

    /// Forgets what was spent. From now on all calls together have this budget, and so have all
    /// scenes together; the budget of all starts is that of `Limits`. A formula that returns is
    /// given up only if its calls took longer than the budget and the worker was also on a
    /// processor for longer than the budget, see `ran`. The reference needs this rule: it never
    /// sleeps, but its replies come late on a busy machine.
    void begin_again(Seconds budget);

    /// Counts a call that was answered.
    void returned(FormulaIndex formula, Seconds took);
    /// Counts a call, or a wait within a scene, that ended without an answer.
    void failed(FormulaIndex formula, Seconds took, bool timed_out);
    /// Whether this formula has taken so long that the time of each further call is compared with
    /// the time of the reference.
    bool is_compared(FormulaIndex formula) const;
    void compare(FormulaIndex formula, Seconds took, Seconds reference_took);
    /// Sets the time that the worker was on a processor since the budget was begun again, for
    /// requests of any kind.
    void ran(Seconds on_processor) { on_processor_ = on_processor; }

    /// Adds time for which the engine has waited for answers of formulas during a scene.
    void waited_in_scene(Seconds time) { scenes_ += time; }
    /// Counts a scene that failed because of this formula.
    void scene_failed(FormulaIndex formula) { ++of(formula).failed_scenes; }

    /// Counts a start of the worker, whether it succeeded or not.
    void started(Seconds took) { starts_ += took; }
    bool starts_are_used_up() const { return starts_ > limits_.all_starts; }
    /// The time limit of the next start.
    Seconds limit_of_start() const;
    /// Why a start was ended that exceeded `limit`, as the end of a sentence that begins with "the
    /// start of the program".
    std::string why_start_ended(Seconds limit) const;

    /// Whether the formula is not called any more.
    bool is_given_up(FormulaIndex formula) const;
    /// Why the formula was given up, as the end of a sentence that begins with the formula.
    std::string why_given_up(FormulaIndex formula) const;
    /// Whether a scene ends at once when it calls the formula. A formula that was given up still
    /// gets two short chances in scenes, because its arguments may differ there.
    bool ends_scenes(FormulaIndex formula) const;

    /// The floors (lowest time limits) of `Limits`, which are shorter once a budget is used up. The
    /// floor of a wait is also shorter if the formula was given up; the floor of a scene is at most
    /// `Limits::call` if there is a reference.
    Seconds floor_of_call() const { return floor_factor() * limits_.call; }
    Seconds floor_of_wait(FormulaIndex formula) const;
    Seconds floor_of_scene() const;

    Spent spent() const;
    /// A text about the formulas that were given up and the budgets that are used up; empty if
    /// there are none.
    std::string report() const;

private:
    struct Row {
        int timeouts = 0, failed_scenes = 0;
        bool was_given_up = false; // whether an earlier run gave it up
        Seconds answered{}, lost{}, compared{}, by_reference{};
    };

    Row& of(FormulaIndex formula) { return rows_[static_cast<unsigned>(formula)]; }
    const Row& of(FormulaIndex formula) const { return rows_[static_cast<unsigned>(formula)]; }
    bool calls_are_used_up() const { return calls_ > limits_.all_calls; }
    bool scenes_are_used_up() const { return scenes_ > limits_.all_scenes; }
    double floor_factor() const { return calls_are_used_up() ? 0.1 : 1; }
    bool is_too_slow(const Row& row) const;

    Limits limits_;
    bool has_reference_;
    std::array<Row, formula_count> rows_;
    Seconds calls_{}, scenes_{}, starts_{}, on_processor_{};
    bool is_begun_again_ = false;
};

} // namespace rigor
