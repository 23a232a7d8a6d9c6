// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The contact stage of an island in the time step by Guendelman, Bridson and Fedkiw (2003), after
/// the forces: contacts keep bodies from penetrating, without restitution. Each contact gets the
/// normal impulse that brings v·n at least to the target speed (active_contacts.hpp), and the
/// impulse of friction.
///
/// The methods `built_in` and `simultaneous` solve all contacts of an island at once
/// (solvers/island_solver.hpp). They start from the impulses of the previous step (warm start) or
/// from `estimate_loads` (load_estimate.hpp). The other methods resolve one contact at a time
/// (solvers/one_at_a_time.hpp).
///
/// In a world without gravity, a target speed above 0 corrects penetration, which adds energy. An
/// island is corrected in this step only if its contacts take away at least as much energy, or if
/// its bodies hardly move relative to each other. Otherwise the correction waits for a later step.
///
/// @param before_forces  the bodies after the collision stage, before the forces
void process_contact(ContactProblem& problem, const Island& island,
                     std::span<const Body> before_forces);

} // namespace rigor
