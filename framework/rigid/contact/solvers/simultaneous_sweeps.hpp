// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// Sweeps by `resolve_simultaneously`; each sweep is one iteration of that formula.
std::unique_ptr<Sweeps> simultaneous_sweeps(ContactProblem& problem, std::span<const int> active);

} // namespace rigor
