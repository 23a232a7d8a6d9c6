// SPDX-License-Identifier: MIT
// The time that a test program may compute by itself. Its engine works with the answers of a
// submission, and some answers keep it busy without end, even within one step.
//
// A timer counts the processor time in ticks, four in a second. A run that calls formulas without
// end fails at one of these calls. A program that computes for too long between two calls writes a
// message (`LastWords`) and ends itself at once, because it may never come to the next call, where
// it could fail.
#pragma once

#include "formulas/table.hpp"

#include <csignal>
#include <string>

namespace rigor {

/// The exit status of a program that computed for too long between two calls.
inline constexpr int stalled_status = 75;

/// What a program that computed for too long writes before it ends. Between the two parts it writes
/// the name of the formula that was called last.
struct LastWords {
    int descriptor = -1;
    std::string before, after;
};

/// Begins to count the time of a test case on a processor.
/// @param stall  longest time on a processor between two calls of formulas [s]
void watch_own_time(LastWords words, double stall);

/// Limits the time on a processor as long as this object lives. If a second such object is made
/// while the first one lives, both limits hold.
class OwnTimeLimit {
public:
    /// @param subject  for the message: "scene bounce"
    OwnTimeLimit(std::string subject, double seconds);
    ~OwnTimeLimit();
    OwnTimeLimit(const OwnTimeLimit&) = delete;
    OwnTimeLimit& operator=(const OwnTimeLimit&) = delete;

    /// @throws OwnTimeOver if the time of this limit, or of an outer one, is over
    void check() const;

private:
    std::string subject_;
    double seconds_, end_; // the limit, and the processor time at which it is reached [s]
    const OwnTimeLimit* outer_;
};

namespace own_time {

extern volatile std::sig_atomic_t ticks; // ticks of processor time since the last formula call
extern volatile std::sig_atomic_t last_formula;

void check();

} // namespace own_time

/// Called at each call of a formula. The limits are checked only if the timer has ticked since the
/// previous call, so most calls do not read the clock. @throws OwnTimeOver if a limit is exceeded
inline void note_formula(FormulaIndex formula)
{
    own_time::last_formula = static_cast<std::sig_atomic_t>(formula);
    if (own_time::ticks == 0) return;
    own_time::ticks = 0;
    own_time::check();
}

} // namespace rigor
