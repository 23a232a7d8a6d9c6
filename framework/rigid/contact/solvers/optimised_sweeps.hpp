// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// Makes the same sweeps as the reference's formulas for the methods `built_in` and `simultaneous`,
/// but without calling the formulas.
///
/// @param island  already split into blocks, which the threads of the problem's pool share
std::unique_ptr<Sweeps> optimised_sweeps(ContactProblem& problem, const Island& island,
                                         std::span<const int> active);

} // namespace rigor
