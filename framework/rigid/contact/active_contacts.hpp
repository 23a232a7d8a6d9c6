// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The contacts of an island at which an impulse can change the relative velocity, as indices in
/// `problem.contacts`. They are in the order of the island's pairs and, within a pair, sorted by
/// height, lowest first.
///
/// Also sets the target speed of each of these contacts, the least v·n after the contact stage (h:
/// time step):
/// - With a gap it is -gap/h, so that the bodies touch at the end of the step at the earliest.
/// - Without a gap it is `correction_speed` (position_correction.hpp).
/// - In a pile (`is_pile`), a gap of at most 2e-4 of the contact's radius counts as closed, and the
///   target speed is 0. Otherwise the pile would never rest.
///
/// In each case passes_by/h is subtracted, because the gap at the end of the step is larger by
/// `passes_by` than v·n predicts (see `ContactConstraint`).
UninitializedVector<int> activate_contacts(ContactProblem& problem, const Island& island);

} // namespace rigor
