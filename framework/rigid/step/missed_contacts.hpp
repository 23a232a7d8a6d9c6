// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"
#include "rigid/detection/contact_candidates.hpp"

namespace rigor {

/// Whether two bodies may have penetrated or passed through each other in a step because the
/// contacts found for this step are not enough. This may happen in two ways:
/// 1. A collision has sent a body farther than the search for contacts looked: a ball bounces off
///    a wall and reaches the wall behind it within the same step.
/// 2. A body turns so far in the step that its contacts do not hold it, since the contact stage
///    lets their points move along straight lines. The center of the body then passes a contact.
///
/// Both cases are detected from the contacts at the start of the step and the displacements until
/// its end. So the result may also be true for bodies that pass each other closely. In a large
/// island, that is one of more than `most_refined` bodies (overlap_depth.hpp), this would happen in
/// many steps of a pile. There the first case counts only if the bodies overlap at the end of the
/// step, or move so far that they may have passed through each other.
///
/// @param candidates  has to contain at least one contact
/// @param flown       the states after free flight, with which `candidates` was found
/// @param states      the states at the end of the step
bool has_missed_contact(const World& world, const ContactProblem& problem,
                        const ContactCandidates& candidates, const std::vector<RigidState>& flown,
                        const std::vector<RigidState>& states);

} // namespace rigor
