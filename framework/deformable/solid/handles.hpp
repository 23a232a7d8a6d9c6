// SPDX-License-Identifier: MIT
// Prescribed motion of nodes, and the external forces on nodes.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// A node with one or more coordinates that a handle prescribes.
struct HeldNode {
    int node = 0;
    std::array<bool, 3> axes = {true, true, true};
    // Velocity that moves the prescribed coordinates to their prescribed values within the substep
    // [m/s].
    Vector3d velocity = Vector3d::Zero();
};

/// Sets `first_places` of each handle that has none yet to the present positions of its nodes.
void remember_first_places(Deformable& solid);

/// Sets `held` to the nodes that handles hold in the substep that ends at `time`, each once, with
/// the velocities that take these nodes to their prescribed places. If several handles prescribe
/// the same coordinate of a node, the last handle counts.
/// @param entries  memory that is used again from call to call; its numbers mean nothing afterwards
void hold_nodes(const Deformable& solid, double time, double time_step, std::vector<HeldNode>& held,
                std::vector<int>& entries);

/// Gives the held nodes their prescribed velocities, in the coordinates that are prescribed.
void move_held(const std::vector<HeldNode>& held, std::vector<Vector3d>& velocities);

/// Adds the weight of each node and the loads that act at `time` to the forces on the nodes [N].
/// @param gravity  acceleration [m/s²]
void add_loads(const Deformable& solid, const Vector3d& gravity, double time,
               std::vector<Vector3d>& forces);

} // namespace rigor
