// SPDX-License-Identifier: MIT
// What a step leaves for the next one.
#pragma once

#include "rigid/bodies/pair_cache.hpp"

#include "formulas/types.hpp"

#include <vector>

namespace rigor {

/// The impulse that held a contact in the step before: the next step's sweeps start from it.
struct WarmContact {
    int body1 = 0, body2 = 0;
    Vector3d point = Vector3d::Zero();   // in the object space of body 1 [m]
    Vector3d impulse = Vector3d::Zero(); // on body 1, divided by the time step [N]
};

/// A contact as a step has resolved it.
struct ContactRecord {
    int body1 = 0, body2 = 0;
    Vector3d point = Vector3d::Zero();   // [m]
    Vector3d normal = Vector3d::UnitY(); // from body 2 to body 1
    double depth = 0;                    // at the start of the step; negative: the gap it closed [m]
    Vector3d impulse = Vector3d::Zero(); // on body 1, the sum over the step [N s]
};

struct StepMemory {
    std::vector<WarmContact> warm_contacts;       // in the order of their bodies
    std::vector<ContactRecord> sleeping_contacts; // what holds the bodies that sleep
    PairCache pairs; // saves work alone: the result is the same bits without it
};

} // namespace rigor
