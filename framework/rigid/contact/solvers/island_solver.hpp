// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Solves all active contacts of an island at once and applies their impulses.
///
/// Sweeps (sweeps.hpp) visit the contacts from the lowest up, in a large island block by block
/// (blocks.hpp). They are accelerated by the nonsmooth nonlinear conjugate gradient method
/// (Silcowitz-Hansen, Niebe and Erleben 2010, "A nonsmooth nonlinear conjugate gradient method for
/// interactive contact force problems", Visual Computer 26). Newton's method (newton_contact.hpp)
/// continues if the sweeps end before they have converged, the island is not a pile, and one of
/// these is true: its bodies are at rest, it is a single body that touches several others, or its
/// bodies have very different masses and the sweeps ended far from the solution. Further sweeps
/// check the result of Newton's method. The sweeps of a small island converge to rounding. Those of
/// a large island end when the remaining changes are too small to be seen, or after a limited
/// amount of work.
///
/// @param active  indices in `problem.contacts`, at least one
void solve_island(ContactProblem& problem, const Island& island, std::span<const int> active);

} // namespace rigor
