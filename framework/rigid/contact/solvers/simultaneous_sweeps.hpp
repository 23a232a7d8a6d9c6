// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// Sweeps by `resolve_simultaneously`, one of its iterations a sweep.
std::unique_ptr<Sweeps> simultaneous_sweeps(ContactProblem& problem, std::span<const int> active);

} // namespace rigor
