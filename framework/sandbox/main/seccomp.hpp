// SPDX-License-Identifier: MIT
// Filters system calls by rules such as those of calls.hpp.
#pragma once

#include "sandbox/main/calls.hpp"

namespace rigor::confine {

/// Puts the rules in force for this process and all that it starts, forever. Calls without a rule
/// get the verdict `others`. A refused call waits for the grader if `notify`; otherwise it kills
/// the process.
/// @return the listener through which the grader learns of refused calls; -1 without `notify`
int filter_calls(const std::vector<Rule>& rules, Verdict others, bool notify);

} // namespace rigor::confine
