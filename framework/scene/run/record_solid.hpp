// SPDX-License-Identifier: MIT
#pragma once

#include "scene/trajectory/trajectory.hpp"

#include <memory>

namespace rigor {

/// Makes the frames of a deformable solid for a trajectory. Surface and pieces are computed again
/// only if the mesh has changed.
class SolidRecorder {
public:
    /// @param time  time of the frame, for the error message [s]
    /// @throws NonFiniteState if a number is infinite or NaN
    SolidFrame frame(const Deformable& solid, double time);

private:
    std::shared_ptr<const SolidTopology> topology_; // the mesh in the frame before
    int change_ = 0; // the value of `Deformable::topology` when `topology_` was made
};

} // namespace rigor
