// SPDX-License-Identifier: MIT
// The step of a world with a single body, which meets nothing: only free flight is left of it.
#pragma once

#include "rigid/bodies/world.hpp"

namespace rigor {

/// Whether a world has one body, which moves and on which nothing but gravity acts.
bool is_lone_body(const World& world);

/// The step of such a world, without lists and stages.
/// @return no contacts
std::vector<ContactRecord> step_lone_body(World& world, double time_step);

} // namespace rigor
