// SPDX-License-Identifier: MIT
// How the nodes of a solid move through a step.
#pragma once

#include "deformable/contact/rigid_colliders.hpp"
#include "deformable/motion/workspace.hpp"

namespace rigor {

/// A solid, all that acts on it, and for how long.
struct NodeMotion {
    Deformable& solid;
    Workspace& work;
    RigidColliders& rigid;
    Vector3d gravity;     // [m/s²]
    double start = 0;     // [s]
    double time_step = 0; // [s]
    double radius = 0;    // of a ball that would hold the solid, about [m]
    Counters& counters;
};

} // namespace rigor
