// SPDX-License-Identifier: MIT
// What one submission may cost: the time of all its requests together, and the formulas that are
// not asked any more. So an endless loop costs only seconds, however many tests and other formulas
// reach it. Time counts as in `Limits`: while the worker is on a processor, or asleep while the
// client waits.
//
// The first seconds are free (`Limits::all_calls` and `all_scenes`). When they are used up, a call
// or a scene gets a tenth of its usual floor, or `Limits::multiple` times what the reference takes
// for the same, whichever is longer. So a solution that is slow and right is graded to its end, and
// one that does not return is soon given up.
#pragma once

#include "formulas/table.hpp"
#include "worker/process.hpp"

#include <array>
#include <string>

namespace rigor {

/// What a submission has cost so far. A later run of the same submission goes on from this.
struct Spent {
    std::chrono::duration<double> calls{}, scenes{};
    std::vector<FormulaIndex> given_up;
};

class TimeBudget {
public:
    using Seconds = std::chrono::duration<double>;

    /// @param has_reference  whether there is a reference to compare with
    TimeBudget(const Limits& limits, bool has_reference);

    /// Goes on from what an earlier run has spent.
    void go_on_from(const Spent& spent);

    /// Forgets what was spent. From now on, `free` is the free time of all calls together, and also
    /// that of all scenes together.
    void begin_again(Seconds free);

    /// Counts a call that was answered.
    void returned(FormulaIndex formula, Seconds took);
    /// Counts a call, or a wait within a scene, that ended without an answer.
    void failed(FormulaIndex formula, Seconds took, bool timed_out);
    /// Whether the time of this formula's answers is compared with the reference's from now on.
    bool is_compared(FormulaIndex formula) const;
    void compare(FormulaIndex formula, Seconds took, Seconds reference_took);

    /// Counts time for which the engine has waited, within a scene, for answers of formulas.
    void scene_took(Seconds time) { scenes_ += time; }
    /// Counts a scene that failed because of this formula.
    void scene_failed(FormulaIndex formula) { ++of(formula).failed_scenes; }

    /// Whether the formula is not called any more.
    bool is_given_up(FormulaIndex formula) const;
    /// Why the formula was given up, as the end of a sentence that begins with the formula.
    std::string why_given_up(FormulaIndex formula) const;
    /// Whether a scene ends at once when it calls the formula. A formula that was given up still
    /// gets two short chances in scenes, because its arguments may differ there.
    bool ends_scenes(FormulaIndex formula) const;

    /// The floors of `Limits`, which are shorter when the free time is used up.
    Seconds floor_of_call() const { return floor_factor() * limits_.call; }
    Seconds floor_of_wait(FormulaIndex formula) const;
    Seconds floor_of_scene() const;

    Spent spent() const;
    /// A sentence about the formulas that are not asked any more and the free times that are used
    /// up; empty if there are none.
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
    Seconds calls_{}, scenes_{};
};

} // namespace rigor
