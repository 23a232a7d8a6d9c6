// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The contact stage of the time step by Guendelman, Bridson and Fedkiw (2003), after the forces:
/// contacts keep bodies from penetrating, without restitution. Each contact gets the impulse that
/// brings its normal velocity at least to its target speed (active_contacts.hpp), and the
/// impulse of friction.
///
/// The methods `built_in` and `simultaneous` solve all contacts of an island at once
/// (solvers/island_solver.hpp); they start from the impulses of the previous step or from
/// `estimate_loads` (load_estimate.hpp). The other methods resolve one contact at a time
/// (one_at_a_time.hpp).
///
/// In a world without gravity, penetration is corrected by a target speed, which adds energy. The
/// correction is made in this step only if the contacts take away at least as much energy, or if
/// the bodies hardly move relative to each other; otherwise it waits for a later step.
void process_contact(ContactProblem& problem);

} // namespace rigor
