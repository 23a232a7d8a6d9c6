// SPDX-License-Identifier: MIT
// The rigid bodies that deformable solids collide with.
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/world.hpp"

namespace rigor {

/// The rigid bodies during a step of the deformable solids. As in the step of the rigid bodies,
/// impulses act at the poses of the start of the step, so that angular momentum is conserved up to
/// rounding errors. Only `surfaces`, to which distances are measured, move with each substep.
struct RigidColliders {
    explicit RigidColliders(const World& world);

    /// Moves the surfaces with the velocities of their bodies for a substep of this length [s].
    void advance(double time_step);
    /// Writes the velocities after the impulses to the world, and wakes the bodies that got an
    /// impulse. A body that only nodes carry has to fall by h² g in a step; the part of this fall
    /// that the integrator of the rigid bodies leaves out is added to its position.
    void apply_to(World& to, double time_step) const;
    void push(int body, const Vector3d& point, const Vector3d& impulse);

    const World& world;
    std::vector<Body> bodies;
    std::vector<Pose> surfaces;
    std::vector<char> is_pushed;
    /// Whether each body was asleep or in contact with other rigid bodies when the step began.
    std::vector<char> is_supported;
};

} // namespace rigor
