// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Solves all active contacts of an island at once and applies their impulses.
///
/// Sweeps (sweeps.hpp) visit the contacts from the lowest up and are accelerated by the nonsmooth
/// nonlinear conjugate gradient method (Silcowitz-Hansen, Niebe and Erleben 2010, "A nonsmooth
/// nonlinear conjugate gradient method for interactive contact force problems", Visual Computer
/// 26). If they end before they have converged and the bodies are at rest, Newton's method
/// (newton_contact.hpp) continues, and further sweeps check its result. The sweeps of a small
/// island converge to rounding. Those of a large island end as soon as the remaining changes are
/// invisible, or after a limited amount of work.
///
/// @param active  indices of the contacts in the problem, at least one
void solve_island(ContactProblem& problem, const Island& island, std::span<const int> active);

} // namespace rigor
