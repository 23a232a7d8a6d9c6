// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The collision stage of the 2003 time step: bodies that would penetrate bounce, with the velocities
/// they had before this step's forces, so that what rests does not bounce on its own weight.
///
/// Island by island, pair by pair from the lowest up, sweep after sweep until no pair approaches. Of a
/// pair, the deepest point that still approaches comes first (`deepest_approaching_point`), with its
/// depth at the predicted position. Points that are equally deep, to a tenth, touch at the same time as
/// far as this step can tell: their impulse acts in their middle, so that a box that lands flat does
/// not start to spin. A bounce that would be over within the step is left to the contact stage. No
/// bounce gives energy: with restitution and friction together, an impulse that would is shortened.
void process_collisions(ContactProblem& problem);

} // namespace rigor
