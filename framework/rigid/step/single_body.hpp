// SPDX-License-Identifier: MIT
// The step of a world with a single rigid body. As there is no other rigid body to touch, free
// flight is the only stage. In a step in which deformable solids push the body, forces act on the
// body, and the general step moves it instead (deformable/step).
#pragma once

#include "rigid/bodies/world.hpp"

namespace rigor {

/// Whether a world has exactly one body, and this body can move and only gravity acts on it.
bool is_single_body(const World& world);

/// The step of a world for which `is_single_body` is true. It makes no lists of bodies or contacts
/// and runs no stage but free flight. It removes the warm contacts of an earlier step.
/// @return an empty list, since there are no contacts
std::vector<ContactRecord> step_single_body(World& world, double time_step);

} // namespace rigor
