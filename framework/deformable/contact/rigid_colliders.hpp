// SPDX-License-Identifier: MIT
// The rigid bodies that deformable solids collide with.
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/world.hpp"

#include <optional>

namespace rigor {

/// The rigid bodies during a step of the deformable solids. As in the step of the rigid bodies,
/// impulses act at the poses of the start of the step, so that angular momentum is conserved up to
/// rounding errors. Only `surfaces`, to which distances are measured, move with each substep.
struct RigidColliders {
    explicit RigidColliders(const World& world);

    /// Moves the surfaces with the velocities of their bodies for a substep of this length [s].
    void advance(double time_step);
    /// Between these two calls a solid moves in substeps, which together take this time step [s].
    void begin_substeps();
    void end_substeps(double time_step);
    /// Adds the velocity that gravity gives in this time [s] to the bodies that nothing rigid
    /// carries. The step of the rigid bodies adds it too, so `end_substeps` takes it back.
    void fall(double time);
    /// Writes the velocities of the bodies that got an impulse to the world, and wakes these
    /// bodies. A body that only nodes carry has to move as they do. The part of this motion that
    /// the integrator of the rigid bodies leaves out is added to the position of the body.
    void apply_to(World& to, double time_step) const;
    void push(int body, const Vector3d& point, const Vector3d& impulse);

    const World& world;
    std::vector<Body> bodies;
    std::vector<Pose> surfaces;
    std::vector<char> is_pushed;
    /// Whether each body is asleep when the step begins, or got an impulse from another rigid body
    /// in the contact stage of the step before.
    std::vector<char> is_supported;

private:
    Vector3d lack_of_motion(std::size_t body, double time_step) const;

    std::vector<char> pushed_before_;
    /// Where the substeps of the last solid that pushed a body have brought the body's center.
    std::vector<std::optional<Vector3d>> reached_;
};

} // namespace rigor
