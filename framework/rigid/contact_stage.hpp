// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact_problem.hpp"

namespace rigor {

/// The third stage of the 2003 time step: after the forces, contacts hold. No restitution. The normal
/// velocity that is asked for is -gap/h where there is a gap, to touch at the end of the step and not
/// before; else 0.
///
/// The methods that solve all contacts at once sweep over them (sweeps.hpp). Sweeps start from the
/// impulses of the step before, or from `guess_loads`; run from the lowest contact up; and are sped
/// up by the nonsmooth nonlinear conjugate gradient method (Silcowitz-Hansen, Niebe and Erleben 2010,
/// "A nonsmooth nonlinear conjugate gradient method for interactive contact force problems", Visual
/// Computer 26). A small island converges to rounding; a large one until what is left is invisible,
/// or until it had its share of work.
///
/// Without gravity, penetration heals by a speed: its energy is what the contacts take away in this step,
/// or else it waits; only bodies that hardly move against each other get it for nothing.
void process_contact(ContactProblem& problem, const Island& island);

} // namespace rigor
