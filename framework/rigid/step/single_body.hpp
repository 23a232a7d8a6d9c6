// SPDX-License-Identifier: MIT
// The step of a world with a single rigid body. There is no other rigid body that it could touch,
// so free flight is the only stage. In a step in which deformable solids push the body, their
// forces act on it, and the general step moves it (deformable/step).
#pragma once

#include "rigid/bodies/world.hpp"

namespace rigor {

/// Whether a world has exactly one body, which moves and on which only gravity acts.
bool is_single_body(const World& world);

/// The step of a world for which `is_single_body` is true. It makes no lists of bodies or contacts
/// and runs no stage but free flight. It removes the warm contacts of an earlier step.
/// @return an empty list, since there are no contacts
std::vector<ContactRecord> step_single_body(World& world, double time_step);

} // namespace rigor
