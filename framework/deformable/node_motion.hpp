// SPDX-License-Identifier: MIT
// How the nodes of a solid move through a step.
#pragma once

#include "deformable/node_contacts.hpp"
#include "deformable/workspace.hpp"

namespace rigor {

/// A solid, all that acts on it, and for how long.
struct NodeMotion {
    Deformable& solid;
    Workspace& work;
    RigidSide& rigid;
    Vector3d gravity;     // [m/s²]
    double start = 0;     // [s]
    double time_step = 0; // [s]
    double radius = 0;    // of a ball that would hold the solid, about [m]
    Counters& counters;
};

/// Symplectic Euler in substeps that are stable: v += h f(x, v)/m, then x += h v. Drag as
/// v/(1 + α h).
void move_explicitly(const NodeMotion& motion);

/// Backward Euler: one linear system for the velocities, then x += h v. Contacts tie nodes to surfaces
/// in the system itself; which of them hold, stick or slide is found by trying (an active set), at most
/// ten times.
void move_implicitly(const NodeMotion& motion);

/// Gives held nodes the velocity that takes them where they belong.
void move_held(const std::vector<HeldNode>& held, std::vector<Vector3d>& velocities);

} // namespace rigor
