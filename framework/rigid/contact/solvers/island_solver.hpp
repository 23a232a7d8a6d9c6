// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Solves all active contacts of an island at once and applies their impulses.
///
/// Sweeps (sweeps.hpp) visit the pairs of bodies by the height of their lowest contact, lowest
/// first; in a large island they do so block by block (blocks.hpp). In islands of up to 1000
/// contacts, the sweeps are accelerated by the nonsmooth nonlinear conjugate gradient method
/// (Silcowitz-Hansen, Niebe and Erleben 2010, "A nonsmooth nonlinear conjugate gradient method for
/// interactive contact force problems", Visual Computer 26). The sweeps of a small island end when
/// the remaining changes are rounding errors, those of a large island when the changes are too
/// small to be seen. In both cases the number of sweeps is limited.
///
/// If the sweeps end before they have converged, Newton's method (newton_contact.hpp) may continue,
/// and further sweeps check its result. Newton's method continues only for an island that is not a
/// pile (`is_pile`), in these cases:
/// - The island is at rest relative to a static or driven body that it touches. If other forces
///   than gravity push its bodies together, Newton's method also comes before the sweeps, where no
///   impulses of an earlier step are known.
/// - The island is a single body that touches several static or driven bodies.
/// - The masses of its bodies are very different, and the sweeps have ended far from the solution.
///
/// Where sweeps that have not converged end far from the law of contact (far_from_law.hpp), they
/// start again from zero impulses, and a result of Newton's method that is far from it is not used.
/// In a jam, where no motion obeys the law, only few sweeps are done, so that driven bodies may
/// press themselves into others, but do not shoot them away.
///
/// @param active  indices in `problem.contacts`, at least one
void solve_island(ContactProblem& problem, const Island& island, std::span<const int> active);

} // namespace rigor
