// SPDX-License-Identifier: MIT
#pragma once

#include "scene/trajectory.hpp"

namespace rigor {

/// A world, and what its trajectory records about the bodies.
struct RecordedWorld {
    World world;
    std::vector<RecordedBody> bodies;
};

RecordedWorld make_recorded_world(const Scene& scene, const RunSettings& settings);

} // namespace rigor
