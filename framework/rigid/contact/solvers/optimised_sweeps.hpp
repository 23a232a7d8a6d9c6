// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// Sweeps for the contact methods `built_in` and `simultaneous` that call no formula. Up to
/// rounding, they give the same result as sweeps that call the formulas of the reference
/// implementation. The students' tree has another source of this name, which calls the formulas.
///
/// @param island  has to have blocks (`split_into_blocks`), since only pairs in blocks are swept;
///                the threads in `problem.pool` share the blocks
std::unique_ptr<Sweeps> optimised_sweeps(ContactProblem& problem, const Island& island,
                                         std::span<const int> active);

} // namespace rigor
