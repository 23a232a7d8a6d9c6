// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <vector>

namespace rigor {

/// What the one who runs a scene decides, not its file.
struct RunSettings {
    bool formulas_are_reference = false; // see World
    int threads = 1;
};

/// Shapes to bodies: calls the formulas of topic `inertia` where the scene gives densities.
World make_world(const Scene& scene, const RunSettings& settings = {});

/// The same, and the deformable solids.
DeformableWorld make_deformable_world(const Scene& scene, const RunSettings& settings = {});

/// A world, and what its trajectory records about the bodies.
struct RecordedWorld {
    DeformableWorld world; // without solids: the rigid one is all of it
    std::vector<RecordedBody> bodies;
};

RecordedWorld make_recorded_world(const Scene& scene, const RunSettings& settings);

} // namespace rigor
