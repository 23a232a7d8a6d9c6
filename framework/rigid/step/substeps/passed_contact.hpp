// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The time at which a contact of the island closes that a body would pass: it got no impulse,
/// since a later bounce of one of its two bodies turned this body back. Example: a ball flies
/// towards a wall and would first hit a small ball; after the computed bounce off the wall it never
/// meets the small ball.
/// @return the earliest time of all such contacts, since the start of the step [s]; infinity if
///         there is none
double closing_of_passed_contact(const World& world, const ContactProblem& problem,
                                 const Island& island);

} // namespace rigor
