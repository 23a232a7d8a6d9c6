// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/step_memory.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Gives contacts the impulses of the previous step as initial impulses. A contact takes the
/// impulse of the nearest old contact of the same two bodies within a tenth of the smaller body's
/// radius. The impulse's tangential part is shortened to the contact's own friction cone, and an
/// impulse that would pull becomes zero.
///
/// @param before  the contacts of the previous step, sorted by `body1`, then `body2`
/// @param poses   the poses of all bodies at the start of the step
/// @param pairs   pairs of bodies, each with its range of contacts, in ascending order
/// @return the number of contacts that got an impulse
std::uint64_t start_warm(std::span<const WarmContact> before, const std::vector<Pose>& poses,
                         double time_step, std::span<const ContactPair> pairs,
                         std::span<ContactConstraint> contacts);

/// The impulses of the contacts of this step, divided by the time step, from which the next step
/// can start. An empty list after a step that took no time. `collect_contacts` (step/step_result)
/// calls it, and `finish_step` stores the result in `StepMemory::warm_contacts`.
///
/// @param contacts  grouped by pairs of bodies, in ascending order
std::vector<WarmContact> warm_contacts(const std::vector<Pose>& poses,
                                       std::span<const ContactConstraint> contacts,
                                       double time_step);

} // namespace rigor
