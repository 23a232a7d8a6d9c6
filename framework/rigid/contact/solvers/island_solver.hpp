// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Solves all active contacts of an island at once and applies their impulses.
///
/// Sweeps (sweeps.hpp) run from the lowest contact up and are accelerated by the nonsmooth nonlinear
/// conjugate gradient method (Silcowitz-Hansen, Niebe and Erleben 2010, "A nonsmooth nonlinear
/// conjugate gradient method for interactive contact force problems", Visual Computer 26). Where they
/// end early and the bodies rest, Newton's method (newton_contact.hpp) goes on, and the sweeps judge
/// its answer. A small island converges to rounding; a large one until what is left is invisible, or
/// until it has had its share of work.
void solve_island(ContactProblem& problem, const Island& island, std::span<const int> active);

} // namespace rigor
