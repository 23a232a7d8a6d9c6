// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The contact stage of the time step by Guendelman, Bridson and Fedkiw (2003), after the forces:
/// contacts keep bodies from penetrating, without restitution. Each contact gets the impulse that
/// brings its normal velocity to its target speed (active_contacts.hpp), with friction.
///
/// The methods `built_in` and `simultaneous` solve all contacts of an island at once
/// (solvers/island_solver.hpp); they start from the impulses of the previous step or from
/// `estimate_loads`. The other methods resolve one contact at a time (one_at_a_time.hpp).
///
/// Without gravity, penetration is corrected by a speed, which adds energy. The correction is made
/// in this step only if the contacts take away at least that energy, or if the bodies hardly move
/// relative to each other; otherwise it is left to a later step.
void process_contact(ContactProblem& problem);

} // namespace rigor
