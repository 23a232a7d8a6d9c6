// SPDX-License-Identifier: MIT
// Data that one step keeps for the next one.
#pragma once

#include "rigid/bodies/pair_cache.hpp"

#include "formulas/types.hpp"

#include <vector>

namespace rigor {

/// A contact of one step with its mean force, from which the sweeps of the next step start.
/// `warm_contacts` (contact/warm_start) makes it when a step ends, and `start_warm` reads it when
/// the contact problem of the next step is made.
struct WarmContact {
    int body1 = 0, body2 = 0;
    Vector3d point1 = Vector3d::Zero();     // in object space of body 1 [m]
    Vector3d point2 = Vector3d::Zero();     // the same point in object space of body 2 [m]
    Vector3d mean_force = Vector3d::Zero(); // on body 1: contact-stage impulse / time step [N]
};

/// A contact that got an impulse in a step.
struct ContactRecord {
    int body1 = 0, body2 = 0;
    Vector3d point = Vector3d::Zero();   // [m]
    Vector3d normal = Vector3d::UnitY(); // from body 2 to body 1
    // Penetration, negative for a gap [m]. It is measured at the start of the step or, if the step
    // was divided, at the start of the part that solved the contact. If `bounce_at_impacts` moved
    // the bounce to its time of impact, the penetration is measured at that time.
    double depth = 0;
    Vector3d impulse = Vector3d::Zero(); // on body 1, in the whole step or in that part [N s]
};

/// A contact of a sleeping body, with the impulse of the step in which the body fell asleep.
struct SleepingContact : ContactRecord {
    double time_step = 0; // length of that step [s]
};

/// What a step leaves for the next one. At the end of a step, `finish_step` (step/step_result)
/// replaces the warm contacts; in a world of a single body, `step_single_body` removes them
/// instead. step/sleep stores the contacts of bodies that fall asleep as sleeping contacts. When
/// the bodies wake, it moves their sleeping warm contacts back to the warm contacts.
/// detection/broad_phase writes the pairs. The time for which a body has been at rest is in
/// `RigidBody::rest`.
///
/// `start_warm` reads the warm contacts. step/substeps/island_world copies those of a part of
/// the world. deformable/contact/movers reads them too, also if the warm start is turned off, to
/// see which bodies lie on each other.
struct StepMemory {
    std::vector<WarmContact> warm_contacts;          // sorted by `body1`, then `body2`
    std::vector<SleepingContact> sleeping_contacts;  // contacts that support sleeping bodies
    std::vector<WarmContact> sleeping_warm_contacts; // become warm contacts when the bodies wake
    PairCache pairs; // only saves time: without this cache, the results are bitwise the same
};

} // namespace rigor
