// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"
#include "rigid/detection/contact_candidates.hpp"

#include <functional>

namespace rigor {

/// The contacts of the islands whose step was repeated.
struct Refinement {
    std::vector<ContactRecord> records;
    std::vector<WarmContact> warm_contacts;
};

/// Does a step of a world and returns its contacts.
using Step = std::function<std::vector<ContactRecord>(World& world, double time_step)>;

/// How often a step may be divided. The limit guards the time: by halves, the shortest part is a
/// 1024th of the step.
inline constexpr int most_divisions = 10;

/// Repeats the step of an island in two parts if it left two bodies overlapping.
///
/// During a step, a contact acts along one fixed normal. Bodies may slide any distance across it,
/// but a body that rotates by θ leaves its contact plane by up to θ² r/2, and sweeps that ended
/// early leave some approach speed. The island's step is repeated if two bodies overlap anew
/// because of this: by more than 1/200 of the thinner one's thickness if they rotate, otherwise by
/// more than 1/20.
///
/// A step in which two moving balls meet and bounce is divided at the time of impact,
/// because the direction of the bounce belongs to that moment. (`bounce_at_impacts` has done so
/// already for most bounces of two bodies that nothing else touches.)
///
/// Only islands of up to 32 bodies on which nothing but gravity pulls are refined.
///
/// @param problem  the impulses of repeated islands are removed from it
/// @param states   the states after the step; those of repeated islands are replaced
/// @param step     advances a world by one part of the step; it may divide that part again
Refinement refine_by_substeps(World& world, ContactProblem& problem,
                              const std::vector<bool>& pulled, const ContactCandidates& candidates,
                              std::vector<RigidState>& states, const Step& step);

} // namespace rigor
