// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Whether the contact of a pair runs far round the circular rim of a body within the step, or the
/// tilt of this body falls by much. A can that rocks over its rim is an example: shortly before it
/// would lie flat, its contact runs to the other side. In a long step it falls flat instead, and
/// loses its energy. A body that lies flat does not count.
///
/// @param states  the states after the step
bool runs_round_rim(const World& world, const ContactProblem& problem,
                    const std::vector<RigidState>& states, const ContactPair& pair);

} // namespace rigor
