// SPDX-License-Identifier: MIT
// What pulls at the bodies: gravity, springs, applied forces.
#pragma once

#include "rigid/world.hpp"

#include <span>

namespace rigor {

/// How a body lies and moves at one moment: what a force on it depends on.
struct Motion {
    Matrix3d R = Matrix3d::Identity();
    Vector3d X = Vector3d::Zero();     // [m]
    Vector3d V = Vector3d::Zero();     // [m/s]
    Vector3d omega = Vector3d::Zero(); // [rad/s]
};

/// For each body, whether springs or applied forces pull at it at some time in [time, time + step].
/// Static bodies: false.
std::vector<bool> pulled_bodies(const World& world, double time_step);

/// Gravity alone. For the integrator `matrix` it is a point force at the center of mass, through
/// `net_wrench`; for the others it is `gravity_wrench`. Without gravity no formula is called.
Wrench gravity_on(const World& world, const RigidBody& body, const Vector3d& X);

/// Against gravity, unit; along y without gravity.
Vector3d up_against(const Vector3d& gravity);

/// Net force and torque on every body by springs, applied forces and gravity.
///
/// Points of attachment move by `world_point` and, if a spring damps, `point_velocity`. A body that
/// nothing pulls at costs no formula but gravity's.
///
/// @param motions  of all bodies, in order
std::vector<Wrench> wrenches(const World& world, std::span<const Motion> motions, double time);

} // namespace rigor
