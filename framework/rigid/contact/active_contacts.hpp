// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The contacts of an island at which an impulse can change the relative velocity, as indices into
/// `problem.contacts`. They are in the order of the island's pairs; within a pair they are sorted
/// by height, lowest first.
///
/// Also sets the `target_speed` of each of these contacts. This is the least v·n that the contact
/// must have after the contact stage (v: relative velocity, n: normal, h: time step):
/// - With a gap, the target speed is -gap/h, so that the bodies do not touch before the end of the
///   step.
/// - Without a gap, the target speed is `correction_speed` (position_correction.hpp).
/// - In a pile (`is_pile`), a gap of at most 2e-4 of the contact's radius counts as closed, and the
///   target speed is 0. With the target speed -gap/h, the pile would never come to rest.
///
/// From each of these values gap_correction/h is subtracted, because the gap at the end of the step
/// is larger by `gap_correction` than v·n predicts (see `ContactConstraint`).
UninitializedVector<int> activate_contacts(ContactProblem& problem, const Island& island);

} // namespace rigor
