// SPDX-License-Identifier: MIT
// Setup of a test program. The graded tests and the framework's own tests differ only here.
#pragma once

#include <string>

namespace rigor::testing {

/// Options of our own, taken from the command line before Catch2 sees it.
struct RunOptions {
    std::string worker; // --worker: the executable whose formulas are tested
    std::string oracle; // --oracle: the reference's worker, where there is one
    /// --others reference: formulas that a test case calls and that are not its task's own are
    /// answered by the reference.
    std::string others;
    std::string spent; // --spent: what an earlier run of this worker cost (CostSoFar)
    double stall = 8;  // --stall: longest time to compute between two calls of formulas [s]
    int verdicts = -1; // --verdicts: a file descriptor for JSON lines about the test cases
};

/// Called once, before the first test case.
/// @throws std::runtime_error if an option is missing or wrong
void prepare(const RunOptions& options);

/// A line that is written if a test case computes without end: `before`, the name of the formula
/// called last, and `after`.
struct StalledLine {
    std::string before, after;
};

/// Called before each test case.
/// @param tag      the tag of its task; empty if it has none
/// @param goes_on  whether the test case before was of the same task, and passed
void begin_test_case(const std::string& tag, bool goes_on, const StalledLine& stalled);

/// The last call of a formula in this test case as C++ to paste; empty if there was none or if it
/// is too long to read.
std::string last_call_text();

/// What the worker has cost so far, for a later run and for people.
struct CostSoFar {
    /// Seconds for calls, for scenes and for starts of the worker, and the tags of the formulas
    /// that are not called any more, with spaces between them.
    std::string spent;
    std::string report; // for people; empty while all is within the free time
};
CostSoFar cost_so_far();

/// Why the answers to the formula of this task are wrong, in one sentence. Called after one of the
/// task's test cases failed. Empty if nothing is known.
std::string mistake_text(const std::string& tag);

} // namespace rigor::testing
