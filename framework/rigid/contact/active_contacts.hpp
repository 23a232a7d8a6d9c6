// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The contacts of an island that an impulse can move, in the order of its pairs, from the lowest up:
/// their indices in the problem. Sets their target speeds: -gap/h where there is a gap, so that bodies
/// touch at the end of the step and not before; else what `correction_speed` asks for.
UninitializedVector<int> activate_contacts(ContactProblem& problem, const Island& island);

} // namespace rigor
