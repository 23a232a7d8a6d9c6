// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The time at which a contact of the island stops sliding within the step, since the start of the
/// step [s]. The contact stage gives a contact one force of friction for the whole step. If sliding
/// ends or turns round within the step, friction in truth has its limit, against the sliding, up to
/// this time, and another value after it.
///
/// The time is predicted: with friction at its limit during the whole step, the velocity of sliding
/// would change at a constant rate, and it would pass zero at this time. If several contacts stop
/// sliding, the first time counts.
///
/// @param before_forces  the bodies before the forces
/// @return the time, or 0 if no contact stops, the island has several bodies, one of its contacts
///         bounced, or it lies on a driven body that turns. (Between several bodies, the solver
///         leaves speeds at contacts that stick.)
double end_of_sliding(const ContactProblem& problem, const Island& island,
                      const std::vector<Body>& before_forces);

} // namespace rigor
