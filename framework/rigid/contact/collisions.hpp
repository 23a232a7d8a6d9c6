// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The collision stage of the time step by Guendelman, Bridson and Fedkiw (2003). Bodies that would
/// penetrate bounce off each other. The stage uses the velocities before this step's forces, so
/// that resting bodies do not bounce because of their own weight.
///
/// The stage visits islands one after the other. In an island it sweeps over the pairs of bodies
/// until no pair bounces, at most ten times. A sweep goes from the lowest pair up; if the island
/// was split into blocks (blocks.hpp), it does so in each block. In a pair, the deepest point that
/// still approaches is handled first (`deepest_approaching_point`); depths are those at the end of
/// the step if nothing bounces. If the depths of points differ by at most 10 % of the larger depth,
/// the points count as touching at the same time, and one impulse acts at their mean point, so that
/// a box that lands flat does not start to spin. If the forces would bring the bodies together
/// again within the step, their bounce is left to the contact stage. No bounce may increase the
/// energy: with restitution and friction together, an impulse that would increase the energy is
/// scaled down.
void process_collisions(ContactProblem& problem);

} // namespace rigor
