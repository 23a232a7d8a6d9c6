// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The contacts of an island at which an impulse can change the relative velocity, as indices in
/// `problem.contacts`. They are in the order of the island's pairs and, within a pair, from the
/// lowest up.
///
/// Also sets the target speed of each of these contacts. With a gap, it is -gap/h (h: time step),
/// so that the bodies touch at the end of the step and not before. Without a gap, it is
/// `correction_speed` (position_correction.hpp). A point that rotation carries past the other body
/// without touching it may approach faster, by passes_by/h (see `ContactConstraint`).
UninitializedVector<int> activate_contacts(ContactProblem& problem, const Island& island);

} // namespace rigor
