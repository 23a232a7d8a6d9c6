// SPDX-License-Identifier: MIT
#pragma once

namespace rigor::testing {

/// The largest error as a share of its tolerance, among the comparisons of the running test case
/// that held: 0 if all values are equal, 1 for an error at its bound. The runner sends it with the
/// verdict.
double& largest_error_in_tolerances();

} // namespace rigor::testing
