// SPDX-License-Identifier: MIT
// What moves the nodes of a solid in a step.
#pragma once

#include "deformable/contact/rigid_colliders.hpp"
#include "deformable/motion/workspace.hpp"

namespace rigor {

/// A solid, what acts on it, and the step.
struct NodeMotion {
    Deformable& solid;
    Workspace& work;
    RigidColliders& rigid;
    Vector3d gravity;     // [m/s²]
    double start = 0;     // [s]
    double time_step = 0; // [s]
    double radius = 0;    // half the diagonal of the box around the solid [m]
    Counters& counters;
};

} // namespace rigor
