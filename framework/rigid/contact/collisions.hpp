// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The collision stage of the time step by Guendelman, Bridson and Fedkiw (2003). Bodies that would
/// penetrate bounce off each other. The stage uses the velocities before this step's forces, so
/// that resting bodies do not bounce because of their own weight.
///
/// The stage visits islands one after the other, and the pairs of an island from the lowest up, in
/// sweeps until no pair approaches. In a pair, the deepest point that still approaches is handled
/// first (`deepest_approaching_point`); depths are those at the predicted positions. Points whose
/// depths differ by less than a tenth count as touching at the same time, and their impulse acts at
/// their mean point, so that a box that lands flat does not start to spin. A bounce that would be
/// over within the step is left to the contact stage. No bounce may increase the energy: with
/// restitution and friction together, an impulse that would increase it is scaled down.
void process_collisions(ContactProblem& problem);

} // namespace rigor
