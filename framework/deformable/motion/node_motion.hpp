// SPDX-License-Identifier: MIT
// The data for moving the nodes of a solid in a step.
#pragma once

#include "deformable/contact/rigid_colliders.hpp"
#include "deformable/motion/workspace.hpp"

namespace rigor {

/// A solid, the bodies and gravity that act on it, and the time step.
struct NodeMotion {
    Deformable& solid;
    Workspace& work;
    RigidColliders& rigid;
    Vector3d gravity;     // [m/s²]
    double start = 0;     // time at the start of the step [s]
    double time_step = 0; // [s]
    double radius = 0;    // half the diagonal of the bounding box of the solid [m]
    Counters& counters;
};

} // namespace rigor
