// SPDX-License-Identifier: MIT
// The prescribed motion of a body that nothing can push: a turntable, a piston, the belt of a
// conveyor.
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// A motion prescribed as a function of time. With the moving time s = t - start, limited to 0 …
/// end - start:
///
///     X(t) = X₀ + s V + (sin(2π f s + φ) - sin φ) A,   q(t) = exp(s ω) q₀
///
/// exp(s ω) is the rotation by the rotation vector s ω in world space. The body turns about the
/// origin of its object space. If the drive is a belt, only the surface moves: contacts use the
/// velocities of this motion, but the pose of the body stays the same.
struct Drive {
    Vector3d velocity = Vector3d::Zero();         // V [m/s]
    Vector3d angular_velocity = Vector3d::Zero(); // ω, world space [rad/s]
    Vector3d amplitude = Vector3d::Zero();        // A, world space [m]
    double frequency = 0;                         // f [Hz]
    double phase = 0;                             // φ [rad]
    double start = 0, end = 1e300;                // the body moves between these times [s]
    bool is_belt = false;                         // whether only the surface moves
    Vector3d first_position = Vector3d::Zero();   // X₀ [m]
    Quaternion first_orientation;                 // q₀
};

/// Velocity and angular velocity of a driven body.
struct DriveVelocity {
    Vector3d linear = Vector3d::Zero(), angular = Vector3d::Zero(); // [m/s], [rad/s]
};

/// The velocity at a time, which is the derivative of the motion. It is zero before `start` and
/// from `end` on.
DriveVelocity drive_velocity(const Drive& drive, double time);

/// The mean velocity over the step that starts at `time`: with this velocity the body moves from
/// its pose at the start of the step exactly to its pose at the end. For a time step of 0 it is
/// `drive_velocity`.
DriveVelocity mean_drive_velocity(const Drive& drive, double time, double time_step);

/// The state of a driven body at a time. Its angular momentum is zero, since a driven body is
/// static and its mass is 0. At all times, a belt has its first pose and the velocity zero.
RigidState driven_state(const Drive& drive, double time);

} // namespace rigor
