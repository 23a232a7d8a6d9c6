// SPDX-License-Identifier: MIT
// The rigid bodies that deformable solids collide with.
#pragma once

#include "deformable/contact/movers.hpp"
#include "geometry/shapes/pose.hpp"

#include <vector>

namespace rigor {

/// The rigid bodies during a step of the deformable solids.
///
/// As in the step of the rigid bodies, impulses act at the poses of the start of the step, so that
/// angular momentum is conserved up to rounding errors. Only `surfaces`, to which distances are
/// measured, move with each substep.
class RigidColliders {
public:
    /// @param world  only its counters change, and are set back
    RigidColliders(World& world, double time_step);

    /// What moves when a solid pushes this body.
    const Mover& mover(int body) const { return movers_.by(body); }
    /// The index of this mover.
    int mover_number(int body) const { return movers_.of[body]; }
    /// The velocity of the center of a body, as its mover moves [m/s].
    Vector3d velocity_of(int body) const;

    /// Moves the surfaces with the velocities of the movers for a substep of this length [s].
    void advance(double time_step);
    /// Between these two calls a solid moves in substeps, which together take the time step.
    void begin_substeps();
    void end_substeps();
    /// Gives the movers the velocities that they get by falling for this time [s].
    void fall(double time);
    /// An impulse at a point of a body acts on its mover.
    void push(int body, const Vector3d& point, const Vector3d& impulse);

    /// Prepares the step of the rigid bodies: the impulses of the nodes become forces of this step,
    /// and bodies that were pushed wake. A body that only nodes carry has to move as they do. The
    /// part of this motion that the integrator of the rigid bodies leaves out is added to the
    /// position of the body.
    void apply_to(World& to) const;
    /// Takes these forces back, after the step of the rigid bodies.
    void end_forces(World& to) const { to.forces.resize(first_force_); }

    const World& world;
    std::vector<Pose> surfaces; // one for each body

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
    // For each mover, whether the last solid that pushed it moved in substeps. If so, `reached`
    // says for each of its bodies where these have brought the center.
    std::vector<char> has_reached_;
    std::size_t first_force_; // how many forces the scene has
};

} // namespace rigor
