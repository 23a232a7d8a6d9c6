// SPDX-License-Identifier: MIT
// The rigid bodies that deformable solids collide with.
#pragma once

#include "deformable/contact/movers.hpp"
#include "geometry/shapes/pose.hpp"

#include <vector>

namespace rigor {

/// The rigid bodies during a step of the deformable solids.
///
/// As in the step of the rigid bodies, impulses act at the poses of the start of the step. Only
/// `surfaces`, to which distances are measured, move with each substep. A point of a moved surface
/// has to be moved back with the center of its body (`at_start`). Its lever arm is then that of the
/// substep, so that angular momentum is conserved up to rounding errors.
class RigidColliders {
public:
    /// @param world  is not changed: `movers_of` restores the counters that its prediction changes
    RigidColliders(World& world, double time_step);

    /// The mover of a body: what moves when a solid pushes this body.
    const Mover& mover(int body) const { return movers_.by(body); }
    /// The index of the mover of a body.
    int mover_number(int body) const { return movers_.of[body]; }
    /// The velocity of the center of a body, as a point of its mover [m/s].
    Vector3d velocity_of(int body) const;

    /// Moves the surfaces with the velocities of the movers for a substep of this length [s].
    void advance(double time_step);
    /// A solid that moves in substeps calls these two functions before the first and after the last
    /// substep. The substeps together take the time step. `end_substeps` takes back the velocities
    /// that `fall` has added in the substeps.
    void begin_substeps();
    void end_substeps();
    /// Adds to the velocities of the movers the change that their accelerations cause in this time
    /// [s]. A negative time takes such a change back.
    void fall(double time);
    /// A point of the surface of a body, moved back with the center of the body to the start of the
    /// step.
    Vector3d at_start(int body, const Vector3d& x) const;
    /// Applies an impulse [N s] at a point of a body (`at_start`) to the mover of the body.
    void push(int body, const Vector3d& point, const Vector3d& impulse);

    /// Prepares the step of the rigid bodies: turns the impulses of the nodes into forces of this
    /// step, and wakes the pushed bodies. A pushed mover that no rigid body supports has to follow
    /// the nodes. Its bodies are moved here by what the coming step lacks (`lack_of_motion`).
    void apply_to(World& to) const;
    /// Removes the forces that `apply_to` has added. It is called after the step of the rigid
    /// bodies.
    void end_forces(World& to) const { to.forces.resize(first_force_); }

    const World& world;
    std::vector<Pose> surfaces; // for each body, the pose of its surface in the current substep

private:
    struct Pushed {
        Vector3d impulse = Vector3d::Zero(), moment = Vector3d::Zero(); // about the body's center
        bool is_pushed = false;
        Vector3d reached = Vector3d::Zero(); // see `has_reached_`
    };

    Vector3d lack_of_motion(int body) const;

    double time_step_;
    Movers movers_;
    std::vector<Pushed> pushed_;           // for each body
    std::vector<char> pushed_in_substeps_; // for each mover
    // For each mover, whether the last solid that pushed it moved in substeps. If so, `reached` is,
    // for each of its bodies, the position of the center after these substeps.
    std::vector<char> has_reached_;
    std::size_t first_force_; // the number of forces in the world without those of nodes
};

} // namespace rigor
