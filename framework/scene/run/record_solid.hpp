// SPDX-License-Identifier: MIT
#pragma once

#include "scene/trajectory/trajectory.hpp"

#include <memory>

namespace rigor {

/// What a trajectory records of a deformable solid, frame by frame. Its mesh is looked at only
/// where it changed.
class SolidRecorder {
public:
    /// @param time  for the error [s]
    /// @throws NonFiniteState
    SolidFrame frame(const Deformable& solid, double time);

private:
    std::shared_ptr<const SolidTopology> topology_; // as in the frame before
    int change_ = 0;                                // the change of the mesh that it belongs to
};

} // namespace rigor
