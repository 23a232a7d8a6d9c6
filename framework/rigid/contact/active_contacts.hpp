// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The contacts of an island that an impulse can change, as indices in the problem. They are in the
/// order of the island's pairs and, within a pair, from the lowest up.
///
/// Sets their target speeds. For a contact with a gap it is -gap/h, so that the bodies touch at the
/// end of the step and not before. For any other contact it is `correction_speed`. A point that
/// rotation carries past the other body without touching it may approach by passes_by/h faster (see
/// `ContactConstraint`).
UninitializedVector<int> activate_contacts(ContactProblem& problem, const Island& island);

} // namespace rigor
