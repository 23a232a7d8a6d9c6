// SPDX-License-Identifier: MIT
#pragma once

namespace rigor::testing {

/// The largest error of the running test case as a part of its tolerance, of the comparisons that
/// held: 0 for values that are equal, 1 for one at its bound. The runner sends it with the verdict.
double& largest_error_in_tolerances();

} // namespace rigor::testing
