// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// The same sweeps as the reference's formulas make, of either kind, without calling them.
///
/// @param island  with its blocks, which all threads of the problem's pool sweep
std::unique_ptr<Sweeps> optimised_sweeps(ContactProblem& problem, const Island& island,
                                         std::span<const int> active);

} // namespace rigor
