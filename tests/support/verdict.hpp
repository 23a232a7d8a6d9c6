// SPDX-License-Identifier: MIT
// The verdict of a test case for the report. The matchers fill it in, and the runner sends it.
#pragma once

#include <string>

namespace rigor::testing {

/// The first failure in the running test case.
struct Verdict {
    std::string status;              // a status of result.json; empty without a failure
    std::string expected, actual;    // as text
    double error = 0, tolerance = 0; // error and bound of the worst component
    std::string tolerance_class;     // "R", "O", "S" or "I", as in close.hpp
    std::string place;               // the field, "inertia(0, 1)"; empty for a single number
    long seed = -1;                  // seed of the case that failed; -1 if there is none
};

/// The verdict of the running test case.
Verdict& verdict();

} // namespace rigor::testing
