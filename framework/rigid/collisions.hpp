// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact_problem.hpp"

namespace rigor {

/// The first stage of the 2003 time step: bodies that would penetrate bounce, with the velocities
/// they had before this step's forces, so that what rests does not bounce on its own weight.
///
/// Pair by pair from the lowest up, sweep after sweep until none approaches: of a pair the deepest
/// point that still approaches first (`deepest_approaching_point`), with its depth at the predicted
/// position. Points that are as deep, to a tenth, touch at the same time as far as this step can tell:
/// their impulse acts in their middle, so that a box that lands flat does not start to spin. A bounce
/// that would be over within the step is left to the contact stage. No bounce gives energy: with
/// restitution and friction together an impulse that would is shortened.
void process_collisions(ContactProblem& problem, const Island& island);

} // namespace rigor
