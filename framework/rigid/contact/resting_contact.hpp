// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The contact stage of the 2003 time step: after the forces, contacts hold, without restitution. Each
/// contact gets the impulse that brings its normal velocity to its target speed (active_contacts.hpp),
/// with friction.
///
/// The methods `built_in` and `simultaneous` solve all contacts of an island at once
/// (solvers/island_solver.hpp), from the impulses of the step before or from `estimate_loads`. The
/// others take one contact at a time (one_at_a_time.hpp).
///
/// Without gravity, penetration is corrected by a speed. Its energy is what the contacts take away in
/// this step, or else it waits; only bodies that hardly move against each other get it for nothing.
void process_contact(ContactProblem& problem);

} // namespace rigor
