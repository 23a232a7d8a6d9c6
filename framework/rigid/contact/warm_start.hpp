// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/step_memory.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Gives contacts the impulses that held them in the step before. A contact takes the impulse of the
/// nearest one of the same two bodies within a tenth of the smaller body's radius, turned to its own
/// normal and shortened to its friction cone.
///
/// @param before  the contacts of the step before, in the order of their bodies
/// @param poses   of all bodies, at the start of the step
/// @param pairs   pairs of contacts, in ascending order of their bodies
/// @return how many contacts got an impulse
std::uint64_t start_warm(std::span<const WarmContact> before, const std::vector<Pose>& poses,
                         double time_step, std::span<const ContactPair> pairs,
                         std::span<ContactConstraint> contacts);

/// What the next step can start from. @param contacts  grouped by bodies, in ascending order
std::vector<WarmContact> warm_contacts(const std::vector<Pose>& poses,
                                       std::span<const ContactConstraint> contacts,
                                       double time_step);

} // namespace rigor
