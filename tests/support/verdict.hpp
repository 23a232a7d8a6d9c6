// SPDX-License-Identifier: MIT
// What a test case found out, for the report: filled in by the matchers, sent on by the runner.
#pragma once

#include <string>
#include <vector>

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

/// Notes the seed of the random case that is about to be tried.
void current_seed(unsigned seed);

/// The seeds of a property, n in a row from the run's base seed (`--seed`).
std::vector<unsigned> seeds(unsigned n);
void set_base_seed(unsigned seed);

} // namespace rigor::testing
