// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact_problem.hpp"

namespace rigor {

/// Gives contacts the impulses that held them in the step before: of the same two bodies, the nearest
/// one within a tenth of the smaller body's radius, turned to the contact's normal and cone.
///
/// @param poses  of all bodies, as the step begins
/// @param pairs  of contacts, whose bodies are in ascending order
/// @return how many contacts got one
std::uint64_t start_warm(const World& world, const std::vector<Pose>& poses, double time_step,
                         std::span<const ContactPair> pairs, std::span<SolvedContact> contacts);

/// What the next step can start from. @param contacts  grouped by bodies, in ascending order
std::vector<WarmContact> warm_contacts(const std::vector<Pose>& poses,
                                       std::span<const SolvedContact> contacts, double time_step);

} // namespace rigor
