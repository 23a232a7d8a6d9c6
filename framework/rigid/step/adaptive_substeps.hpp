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

/// How many times a step, and then a part of it, may be divided in two. The limit bounds the run
/// time: after ten halvings a part is a 1024th of the step.
inline constexpr int most_divisions = 10;

/// Repeats the step of an island in two parts if two bodies overlap more at the end than before, or
/// if two moving balls bounce.
///
/// During a step, a contact acts along one fixed normal. Bodies may slide any distance across it,
/// but a body that rotates by θ leaves its contact plane by up to θ² r/2, and sweeps that ended
/// early leave some approach speed. The island's step is repeated if the overlap of two bodies
/// grows because of this: by more than 1/200 of the thinner body's thickness if they rotate,
/// otherwise by more than 1/20.
///
/// A step in which two moving balls meet and bounce is divided at the time of impact, because the
/// balls part along the line of their centers at that time. (Most bounces of two bodies that
/// nothing else touches were already moved to their time of impact by `bounce_at_impacts`.)
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
