// SPDX-License-Identifier: MIT
// The simulated world: bodies, forces, settings, and the memory of the last step.
#pragma once

#include "rigid/bodies/body.hpp"
#include "rigid/bodies/counters.hpp"
#include "rigid/bodies/settings.hpp"
#include "rigid/bodies/step_memory.hpp"
#include "rigid/parallel/thread_pool.hpp"

#include <vector>

namespace rigor {

/// A spring between two points, each attached to a body or, for body = -1, fixed in the world.
struct Spring {
    int body1 = -1, body2 = -1;
    Vector3d point1 = Vector3d::Zero(),
             point2 = Vector3d::Zero(); // object space, or world space [m]
    double stiffness = 0;               // [N/m]
    double damping = 0;                 // along the spring [N s/m]
    double rest_length = 0;             // [m]
};

/// A constant world-space force on a point of a body, from `start` to `end`.
struct AppliedForce {
    int body = 0;
    Vector3d force = Vector3d::Zero(); // [N]
    Vector3d point = Vector3d::Zero(); // object space [m]
    double start = 0, end = 1e300;     // [s]
};

/// Everything that a time step reads and changes: state, settings, and the memory of the last step.
/// step/adaptive_substeps.cpp and step/impact.cpp make parts of a world. They copy the settings as
/// a whole, but a new member that the bodies of a part need has to be copied there.
struct World {
    double time = 0; // [s]
    std::vector<RigidBody> bodies;
    std::vector<Spring> springs;
    std::vector<AppliedForce> forces;

    Settings settings;

    StepMemory memory;
    Counters counters;
    ThreadPool pool; // any number of threads gives bitwise the same results
};

} // namespace rigor
