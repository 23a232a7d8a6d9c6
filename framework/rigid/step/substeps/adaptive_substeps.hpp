// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"
#include "rigid/detection/contact_candidates.hpp"
#include "rigid/step/substeps/divisions.hpp"

#include <functional>

namespace rigor {

/// The results of the islands that repeated their step in two parts: the contacts of both parts,
/// and the impulses with which the next step starts (contact/warm_start.hpp).
struct Refinement {
    std::vector<ContactRecord> records;
    std::vector<WarmContact> warm_contacts;
};

/// Does a part of a divided step of a world and returns its contacts.
using StepOfPart = std::function<std::vector<ContactRecord>(World& world, double time_step,
                                                            const Divisions& divisions)>;

/// Repeats the step of an island in two parts, in these cases. (If more bounces follow
/// in the step, a third part between the two, a very short one, has the first bounce alone.)
/// 1. The overlap of two bodies has grown too much. The step is divided in the middle. During a
///    step, a contact acts along one fixed normal. Sliding in the plane of the contact does no
///    harm. But the points of a body that rotates by θ move out of this plane by up to θ² r/2 (r:
///    its radius), and sweeps that ended early leave some approach speed. The overlap may grow by
///    1/200 of the thinner body's thickness if the sum of θ² r/2 of both bodies exceeds this
///    length, otherwise by 1/20.
/// 2. Two moving balls bounce off each other with ε > 0. The step is divided at the time of impact,
///    because the balls separate along the line through their centers at that time.
/// 3. In an island of at most `few_bodies` bodies, several pairs bounce, among them a ball and a
///    static body with ε > 0, and no contact carries a load. The step is divided at the first
///    impact.
/// 4. The only impulse in the island is a hit after which the two bodies stay together, as at ε = 0
///    under gravity (`Island::lands_at`). The step is divided at the time of impact, because the
///    bodies would be stopped at the start of the step otherwise, before they touch.
/// 5. In an island of a single body, a contact stops sliding (end_of_sliding.hpp). The step is
///    divided at this time, because the force of friction changes then.
/// 6. Springs, applied forces or drag act on an island of at most `few_bodies` bodies, and no
///    contact carries a load but those that are hit. The step is divided at the first impact.
/// 7. Such forces push two bodies together that should bounce, so strongly that they meet within
///    the step although they separate at its start. The step is divided in the middle.
/// 8. The only pair that gets an impulse in an island of at most `few_bodies` bodies bounces with
///    ε > 0, and one end of a body hits before the other end. The step is divided at the first hit,
///    and just after it.
/// 9. The only pair that gets an impulse in such an island bounces with ε > 0, no end hits before
///    the other, but the bounce was not moved to its time of impact. The step is divided in the
///    middle.
/// 10. In an island of a single body, a contact runs far round the rim of this body
///     (rim_contact.hpp). The step is divided in the middle.
/// 11. In an island of at most `few_bodies` bodies, a body would pass a contact, since it bounces
///     off another body that it meets later (passed_contact.hpp). The step is divided just after
///     the contact that it meets first, unless forces press other contacts together.
///
/// In cases 2 and 3, a bounce does not count if `bounce_at_impacts` (impact.hpp) has already moved
/// it to its time of impact.
///
/// An island is refined only if it has at most `most_refined` bodies (overlap_depth.hpp). If
/// springs, applied forces or drag act on it, only the cases 5 to 7 and 11 count. Bodies that
/// springs connect with it move with it; it is not refined if one of them is in another island or
/// may touch one, or if a deformable solid presses on one of them.
///
/// @param world    only its counters change
/// @param problem  the impulses of repeated islands are set to zero in it
/// @param before_forces  the bodies before the forces
/// @param pulled   for each body, whether springs, applied forces or drag act on it
/// @param states   the states after the step; those of repeated islands are replaced
/// @param divisions  those on the way to this step, none for the whole step
/// @param step     advances a world by one part of the step; it may divide this part again
Refinement refine_by_substeps(World& world, ContactProblem& problem,
                              const std::vector<Body>& before_forces,
                              const std::vector<bool>& pulled, const ContactCandidates& candidates,
                              std::vector<RigidState>& states, const Divisions& divisions,
                              const StepOfPart& step);

} // namespace rigor
