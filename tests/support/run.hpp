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
    int verdicts = -1; // --verdicts: a file descriptor for JSON lines about the test cases
};

/// Called once, before the first test case.
/// @throws std::runtime_error if an option is missing or wrong
void prepare(const RunOptions& options);

/// Called before each test case. @param tag  the tag of its task; empty if it has none
void begin_test_case(const std::string& tag);

/// The last call of a formula in this test case as C++ to paste; empty if there was none or if it
/// is too long to read.
std::string last_call_text();

/// Why the answers to the formula of this task are wrong, in one sentence. Called after one of the
/// task's test cases failed. Empty if nothing is known.
std::string mistake_text(const std::string& tag);

} // namespace rigor::testing
