// SPDX-License-Identifier: MIT
#pragma once

#include "scene/trajectory.hpp"

namespace rigor {

/// A world, and what its trajectory records about the bodies.
struct RecordedWorld {
    DeformableWorld world; // without solids: the rigid one is all of it
    std::vector<RecordedBody> bodies;
};

RecordedWorld make_recorded_world(const Scene& scene, const RunSettings& settings);

} // namespace rigor
