// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <vector>

namespace rigor {

/// The settings of a run that are not part of the scene file.
struct RunSettings {
    bool formulas_are_reference = false; // whether the linked formulas are those of reference/
    int threads = 1;
};

/// The rigid bodies of a scene. Formulas of topic `inertia` are called for the bodies that are
/// neither static nor driven, the formula `angular_velocity` for bodies with the key "filmed", and
/// the formula `object_point` for forces with the key "world_point".
World make_world(const Scene& scene, const RunSettings& settings = {});

/// The rigid bodies and the deformable solids of a scene.
DeformableWorld make_deformable_world(const Scene& scene, const RunSettings& settings = {});

/// A world, and the data of its bodies that a trajectory records.
struct RecordedWorld {
    DeformableWorld world; // the rigid bodies, and the solids if there are any
    std::vector<RecordedBody> bodies;
};

RecordedWorld make_recorded_world(const Scene& scene, const RunSettings& settings);

} // namespace rigor
