// SPDX-License-Identifier: MIT
// The simulated world: bodies, forces, settings, and the memory of the last step.
#pragma once

#include "rigid/bodies/body.hpp"
#include "rigid/bodies/counters.hpp"
#include "rigid/bodies/pair_laws.hpp"
#include "rigid/bodies/settings.hpp"
#include "rigid/bodies/step_memory.hpp"
#include "rigid/parallel/thread_pool.hpp"

#include <functional>
#include <vector>

namespace rigor {

/// A spring between two points. Each point is attached to a body or, if the index of this body is
/// -1, fixed in the world.
struct Spring {
    int body1 = -1, body2 = -1;
    Vector3d point1 = Vector3d::Zero(),
             point2 = Vector3d::Zero(); // in the body's object space; world space if body = -1 [m]
    double stiffness = 0;               // [N/m]
    double damping = 0;                 // along the spring [N s/m]
    double rest_length = 0;             // [m]
    bool only_pulls = false;            // true: a rope, slack while shorter than `rest_length`
};

/// A force on a point of a body and a torque on this body, which act from `start` to `end`, in
/// world space unless `turns_with_body`. If the frequency f is not 0, force and torque are
/// multiplied by sin(2π f t + φ). If there is a `factor`, they are also multiplied by its value at
/// time t.
struct AppliedForce {
    int body = 0;
    Vector3d force = Vector3d::Zero();         // [N]
    Vector3d point = Vector3d::Zero();         // object space [m]
    double start = 0, end = 1e300;             // times in the world's time [s]
    Vector3d torque = Vector3d::Zero();        // [N m]
    bool turns_with_body = false;              // true: `force` and `torque` are in object space
    double frequency = 0;                      // f [Hz]; 0: constant
    double phase = 0;                          // φ [rad]
    std::function<double(double)> factor = {}; // a function of the time [s]; empty: 1
    bool is_of_solid = false; // the mean force of a deformable solid over the whole step
};

/// Everything that a time step reads and changes: state, settings, and the memory of the last step.
/// step/substeps/island_world.cpp and step/impact.cpp each build a smaller world from some of the
/// bodies. Both copy all settings (and turn one optimization off). If `World` gets a new member
/// that a smaller world needs, both files have to copy this member too.
struct World {
    double time = 0; // [s]
    std::vector<RigidBody> bodies;
    std::vector<Spring> springs;
    std::vector<AppliedForce> forces;
    std::vector<PairLaw> pair_laws; // sorted by `body1`, then `body2`

    Settings settings;

    StepMemory memory;
    Counters counters;
    ThreadPool pool; // any number of threads gives bitwise the same results
};

} // namespace rigor
