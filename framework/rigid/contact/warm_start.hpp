// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/step_memory.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Gives contacts initial impulses. These are the mean forces of the contacts of the previous step,
/// times the new time step. Old and new contacts of the same two bodies are matched one to one, the
/// nearest first, if their distance is at most a tenth of the new contact's radius. The tangential
/// part of the impulse is shortened to the friction cone of the new contact. An impulse that would
/// pull the bodies together becomes zero.
///
/// @param before  the contacts of the previous step, sorted by `body1`, then `body2`
/// @param poses   the poses of all bodies at the start of the step
/// @param pairs   the ranges of contacts of pairs of bodies, sorted by `body1`, then `body2`
/// @return the number of new contacts that were matched
std::uint64_t start_warm(std::span<const WarmContact> before, const std::vector<Pose>& poses,
                         double time_step, std::span<const ContactPair> pairs,
                         std::span<ContactConstraint> contacts);

/// The contacts to which the contact stage of this step gave an impulse, with this impulse divided
/// by the time step. The sweeps of the next step can start from them. The list is empty if the time
/// step is 0. `collect_contacts` calls this function, and `finish_step` stores the result in
/// `StepMemory::warm_contacts` (both in step/step_result.hpp).
///
/// @param poses     the poses of all bodies at the start of the step
/// @param contacts  the contacts of this step, sorted by `body1`, then `body2`
std::vector<WarmContact> warm_contacts(const std::vector<Pose>& poses,
                                       std::span<const ContactConstraint> contacts,
                                       double time_step);

/// Sorts by `body1`, then `body2`. The contacts of two bodies keep their order.
void sort_by_bodies(std::vector<WarmContact>& contacts);

} // namespace rigor
