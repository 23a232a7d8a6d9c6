// SPDX-License-Identifier: MIT
#pragma once

#include "scene/trajectory/trajectory.hpp"

#include <memory>

namespace rigor {

/// Makes the frames of a deformable solid for a trajectory. The mesh is examined again only if it
/// has changed.
class SolidRecorder {
public:
    /// @param time  time of the frame, for the error message [s]
    /// @throws NonFiniteState
    SolidFrame frame(const Deformable& solid, double time);

private:
    std::shared_ptr<const SolidTopology> topology_; // the mesh in the frame before
    int change_ = 0; // the number of mesh changes when `topology_` was made
};

} // namespace rigor
