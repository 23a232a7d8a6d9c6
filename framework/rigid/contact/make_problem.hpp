// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"
#include "rigid/detection/contact_candidates.hpp"

namespace rigor {

/// The contact problem of a step: the contacts that are near enough to matter, in islands, with their
/// impulse matrices and the impulses that their sweeps start from. Reads the world's bodies, settings
/// and memory; changes its counters.
///
/// @param flown       the states after free flight: what the bodies would do without contacts
/// @param candidates  contacts that stay farther apart in free flight than the margins of both bodies
///                    together are left out
ContactProblem make_problem(World& world, std::span<const RigidState> flown,
                            const ContactCandidates& candidates, double time_step,
                            ThreadPool& pool);

/// The body after a free flight's change of momentum, still at its place at the step's start.
Body with_forces(Body body, const RigidState& start, const RigidState& flown);

} // namespace rigor
