// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// Sweeps for the contact methods `built_in` and `simultaneous` that do not call any formula. They
/// give the same result as sweeps that call the formulas of the reference implementation.
///
/// @param island  must already be split into blocks; the threads of `problem.pool` share the blocks
std::unique_ptr<Sweeps> optimised_sweeps(ContactProblem& problem, const Island& island,
                                         std::span<const int> active);

} // namespace rigor
