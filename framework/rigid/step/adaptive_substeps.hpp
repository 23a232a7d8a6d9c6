// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"
#include "rigid/detection/contact_candidates.hpp"

#include <functional>

namespace rigor {

/// The contacts of the islands whose step was done again.
struct Refinement {
    std::vector<ContactRecord> records;
    std::vector<WarmContact> warm_contacts;
};

/// A step of a world. @return its contacts
using Step = std::function<std::vector<ContactRecord>(World& world, double time_step)>;

inline constexpr int most_halvings = 10; // of a step, one inside the other

/// Does the step of an island again in two halves where it left two bodies in each other.
///
/// A contact holds along one normal during the whole step. Bodies may slide any distance along it, but a
/// body that turns by θ leaves it by up to θ² r/2; and sweeps that ended early leave some speed. Where
/// that makes two bodies overlap anew, by more than 1/200 of the thinner one if they turn, else by more
/// than 1/20, the island's step is done again. Only islands of up to 32 bodies that nothing but gravity
/// pulls at are refined.
///
/// @param problem  the impulses of islands that are done again are taken out of it
/// @param states   after the step; those of such islands are replaced
/// @param step     does one of the halves, and may refine it again
Refinement refine_by_substeps(World& world, ContactProblem& problem,
                              const std::vector<bool>& pulled,
                              const ContactCandidates& candidates,
                              std::vector<RigidState>& states, const Step& step);

} // namespace rigor
