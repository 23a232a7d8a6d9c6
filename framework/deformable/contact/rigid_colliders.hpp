// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/pose.hpp"
#include "rigid/world.hpp"

namespace rigor {

/// The rigid bodies as the solids meet them in a step. Impulses belong to the poses at its start, as in
/// the rigid step, so that angular momentum is kept to rounding; surfaces move on in substeps.
struct RigidColliders {
    explicit RigidColliders(const World& world);

    /// Moves the surfaces on.
    void advance(double time_step);
    /// Gives bodies the velocities that impulses gave them, and wakes those that got any.
    void apply_to(World& to, double time_step) const;
    /// Whether other bodies hold it, or hold on to it.
    bool has_supports(int body) const;
    void push(int body, const Vector3d& point, const Vector3d& impulse);

    const World& world;
    std::vector<Body> bodies;
    std::vector<Pose> surfaces;
    std::vector<char> is_pushed;
};

} // namespace rigor
