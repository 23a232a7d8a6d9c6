// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The collision stage of the time step by Guendelman, Bridson and Fedkiw (2003). Bodies that would
/// penetrate bounce off each other. The stage uses the velocities before this step's forces, so
/// that resting bodies do not bounce because of their own weight.
///
/// The stage visits the islands one after the other. In an island it sweeps over the pairs of
/// bodies until no pair bounces, but at most ten times. In one sweep, a pair may bounce up to four
/// times. A sweep visits the pairs by the height of their lowest contact, lowest first. In an
/// island that was split into blocks (blocks.hpp), the pairs of each block have this order.
///
/// In a pair, the deepest point that still approaches bounces first (`deepest_approaching_point`).
/// Depths are predicted for the end of the step from the current velocities and the forces. Another
/// point of the pair counts as touching at the same time if it approaches along the same normal and
/// the two depths differ by at most 10 % of the larger one. One impulse acts at the mean of all
/// these points, so that a box that lands flat does not start to spin.
///
/// No bounce may increase the energy: with restitution and friction together, an impulse that would
/// increase it is scaled down. These bounces are left to the contact stage:
/// - Those after which the forces would bring the bodies into contact again within the step.
/// - Those of points that only rotation moves towards the other body, if this rotation does not
///   close the gap in this step (the front of a rolling wheel).
/// - With the contact method `simultaneous`, those with ε = 0.
void process_collisions(ContactProblem& problem);

} // namespace rigor
