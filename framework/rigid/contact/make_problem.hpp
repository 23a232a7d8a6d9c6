// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"
#include "rigid/detection/contact_candidates.hpp"

namespace rigor {

/// The contact problem of a step: the contacts that may close in the step, grouped into islands,
/// with their impulse matrices. If the contact method has a warm start and the scene uses it, the
/// contacts also have the impulses from which the sweeps start. Reads the world's time, bodies,
/// pair laws, settings and warm contacts, and changes its counters.
///
/// @param flown       the states after free flight, as if there were no contacts
/// @param candidates  the contacts to choose from; a contact is left out if its gap, predicted for
///                    the end of free flight, is at least the sum of both bodies' margins
ContactProblem make_problem(World& world, std::span<const RigidState> flown,
                            const ContactCandidates& candidates, double time_step,
                            ThreadPool& pool);

/// The body after the forces of the step: the changes of its velocity and angular momentum from
/// `start` to `flown` are added, but its pose stays that of the start of the step.
Body with_forces(Body body, const RigidState& start, const RigidState& flown);

} // namespace rigor
