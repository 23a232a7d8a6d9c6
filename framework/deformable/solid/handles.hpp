// SPDX-License-Identifier: MIT
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// A node with some coordinates that a handle holds.
struct HeldNode {
    int node = 0;
    std::array<bool, 3> axes = {true, true, true};
    Vector3d velocity = Vector3d::Zero(); // of those coordinates, to be where the handle wants it
};

/// Fills in where the nodes of handles were first, where that is not known yet.
void remember_first_places(Deformable& solid);

/// The nodes that handles hold in a substep that ends at `time`, with the velocities that take them to
/// their places. Of several handles at a coordinate the last counts.
void hold_nodes(const Deformable& solid, double time, double time_step,
                std::vector<HeldNode>& held);

/// Gives held nodes the velocity that takes them where they belong.
void move_held(const std::vector<HeldNode>& held, std::vector<Vector3d>& velocities);

/// Adds gravity and the loads that act at `time` [N].
void add_loads(const Deformable& solid, const Vector3d& gravity, double time,
               std::vector<Vector3d>& forces);

} // namespace rigor
