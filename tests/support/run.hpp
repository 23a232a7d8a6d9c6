// SPDX-License-Identifier: MIT
// What a test program does around its test cases; the graded tests and the framework's own differ only here.
#pragma once

#include <string>

namespace rigor::testing {

/// Options of our own, taken from the command line before Catch2 sees it.
struct RunOptions {
    std::string worker; // --worker: the executable whose formulas are tested
    std::string oracle; // --oracle: the reference's worker, where there is one
    int verdicts = -1;  // --verdicts: a descriptor for one JSON line a test case
};

/// Once, before the first test case. Throws std::runtime_error if the options do not do.
void prepare(const RunOptions& options);

/// Before each test case.
void begin_test_case();

} // namespace rigor::testing
