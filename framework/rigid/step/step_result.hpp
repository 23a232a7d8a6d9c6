// SPDX-License-Identifier: MIT
// The end of a step: the results of its stages, and how they become the world's next state.
#pragma once

#include "rigid/contact/contact_problem.hpp"
#include "rigid/detection/contact_candidates.hpp"
#include "rigid/step/substeps/adaptive_substeps.hpp"

namespace rigor {

struct StepResult {
    std::vector<RigidState> states;         // one for each body
    std::vector<ContactRecord> records;     // contacts that got an impulse
    std::vector<WarmContact> warm_contacts; // for the next step; sorted by `body1`, then `body2`
};

/// Adds the contacts that got an impulse to the result: those of the problem, and those of the
/// islands whose step was repeated in parts (`refined`). Also counts contacts and islands in
/// `world.counters`.
///
/// @throws NonFiniteState if a state of the result is infinite or not a number
void collect_contacts(World& world, const ContactProblem& problem,
                      const ContactCandidates& candidates, const Refinement& refined,
                      StepResult& result);

/// Gives the world its new states and memory, and advances its time.
///
/// @return the contacts of awake bodies that got an impulse, and the contacts that hold sleeping
///         bodies
std::vector<ContactRecord> finish_step(World& world, double time_step, StepResult result);

} // namespace rigor
