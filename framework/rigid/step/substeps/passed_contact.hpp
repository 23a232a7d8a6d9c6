// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The time at which a contact of the island closes that a body would pass: it got no impulse,
/// since a later bounce of one of its two bodies turned this body back. A ball that flies towards a
/// wall and meets a pea before it is an example: after the bounce off the wall it never comes near
/// the pea again. The earliest time of all such contacts counts, since the start of the step [s].
/// It is infinity if there is none.
double closing_of_passed_contact(const World& world, const ContactProblem& problem,
                                 const Island& island);

} // namespace rigor
