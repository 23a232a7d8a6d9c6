// SPDX-License-Identifier: MIT
// What a test case found out, for the report: filled in by the matchers, sent on by the runner.
#pragma once

#include <string>

namespace rigor::testing {

/// The first thing that went wrong in the running test case.
struct Verdict {
    std::string status;              // of result.json; empty while all is well
    std::string expected, actual;    // as text
    double error = 0, tolerance = 0; // of the worst component
    std::string tolerance_class;     // "R", "O", "I", "S", "B": rounding, order, invariant, …
    std::string place;               // the field, "inertia(0, 1)"; empty for a single number
    long seed = -1;                  // of the property's counterexample
};

/// The verdict of the running test case.
Verdict& verdict();

} // namespace rigor::testing
