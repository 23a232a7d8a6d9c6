// SPDX-License-Identifier: MIT
#pragma once

#include "deformable/workspace.hpp"

namespace rigor {

/// Fills in where the nodes of handles were first, where that is not known yet.
void remember_first_places(Deformable& solid);

/// The nodes that handles hold in a substep that ends at `time`, with the velocities that take them to
/// their places. Of several handles at a coordinate the last counts.
void hold_nodes(const Deformable& solid, double time, double time_step,
                std::vector<HeldNode>& held);

/// Adds gravity and the loads that act at `time` [N].
void add_loads(const Deformable& solid, const Vector3d& gravity, double time,
               std::vector<Vector3d>& forces);

} // namespace rigor
