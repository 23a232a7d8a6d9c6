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

/// What pulls at the bodies of a world, moment by moment: springs, applied forces, gravity. Its lists are
/// kept from one moment to the next.
class Pulls {
public:
    /// @param bodies  those that springs or applied forces pull at, in order
    Pulls(const World& world, std::span<const int> bodies);

    /// Net force and torque on each of those bodies, in their order.
    ///
    /// Points of attachment move by `world_point` and, if any spring damps, `point_velocity`. A body that
    /// nothing pulls at costs no formula.
    ///
    /// @param states  of all bodies of the world
    /// @param middle  of the step that this is a moment of: what acts then acts all through the step, so that
    ///                an applied force from one step's start to another's gives its whole impulse
    const std::vector<Wrench>& at(std::span<const RigidState> states, double middle);

    /// Whether a spring damps; else the wrenches depend on where the bodies are alone.
    bool any_damps() const { return any_damps_; }

private:
    void add_spring(const Spring& spring);
    void push(int body, const Vector3d& force, const Vector3d& point);

    const World& world_;
    std::span<const int> bodies_;
    bool any_damps_ = false;
    std::vector<Motion> motions_;                 // of all bodies
    std::vector<std::vector<PointForce>> forces_; // on each body
    std::vector<Wrench> net_;
};

} // namespace rigor
