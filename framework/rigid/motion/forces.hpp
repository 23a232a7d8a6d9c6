// SPDX-License-Identifier: MIT
// Forces on bodies apart from contacts: gravity, springs, applied forces and drag.
#pragma once

#include "rigid/bodies/world.hpp"

#include <span>

namespace rigor {

/// Pose and velocities of a body at one time in world space, from which forces are computed.
struct Motion {
    Matrix3d R = Matrix3d::Identity();
    Vector3d X = Vector3d::Zero();     // [m]
    Vector3d V = Vector3d::Zero();     // [m/s]
    Vector3d omega = Vector3d::Zero(); // [rad/s]
};

/// For each body, whether a spring is attached to it, or an applied force acts on it at some time
/// in [time, time + time_step], where `time` is the world's time. False for static bodies.
std::vector<bool> pulled_bodies(const World& world, double time_step);

/// The list `pulled` (from `pulled_bodies`), with true also for each body that has drag, is awake
/// and is not static.
std::vector<bool> with_dragged_bodies(std::vector<bool> pulled, const World& world);

/// A rate, and the index of the body that has it; -1 if no body has a rate above 0.
struct ForceRate {
    double rate = 0; // [1/s]
    int body = -1;
};

/// A bound of the fastest rate at which springs, applied forces and drag change the motion of a
/// body. It is the largest of the following rates of all bodies.
///
///   * The springs of a body, with stiffness k and damping c: the angular frequency of a vibration
///     is at most √(Σ k (K₁ + K₂)), and the rate of a decay at most Σ c (K₁ + K₂). Here K₁ and K₂
///     belong to the two ends of a spring: K = 1/M + r² |I⁻¹| at the distance r from the center of
///     mass of a body that can move, and K = 0 at any other end.
///   * An oscillating force: 2π f. The `factor` of a force is not considered.
///   * A medium: (c + 2 k |V|)/M and d |I⁻¹|, with c, k and d of `Drag`.
ForceRate fastest_force_rate(const World& world);

/// The wrench of gravity alone. For the integrator `matrix` it is a point force at the center of
/// mass X, through `net_wrench`; for all others it comes from `gravity_wrench`. Without gravity no
/// formula is called.
Wrench gravity_on(const Settings& settings, const RigidBody& body, const Vector3d& X);

/// The wrenches of springs, applied forces, drag and gravity, computed at several times one after
/// the other. The lists are kept between the calls, so a step allocates them only once.
class AppliedWrenches {
public:
    /// @param bodies    indices of the bodies on which springs, applied forces, drag or contacts
    ///                  act, in ascending order
    /// @param supports  a constant wrench on each body of the world, by which contacts hold it; or
    ///                  an empty list
    AppliedWrenches(const World& world, std::span<const int> bodies,
                    std::span<const Wrench> supports);

    /// Net force and torque on each body of the list `bodies` of the constructor, in its order.
    ///
    /// The points of attachment are computed by `world_point` and, for a spring with damping, their
    /// velocities by `point_velocity`. If point forces act on a body, `net_wrench` adds them up.
    ///
    /// @param states  the states of all bodies of the world
    /// @param middle  the time in the middle of the substep [s]. A force that acts at this time
    ///                counts as acting during the whole substep. So if the start and the end of a
    ///                force coincide with those of steps, the force gives its full impulse.
    /// @param now     the time to which `states` belong [s]
    const std::vector<Wrench>& at(std::span<const RigidState> states, double middle, double now);

    /// Whether a spring of the world has damping, or drag acts on one of the constructor's
    /// `bodies`. If not, wrenches depend only on poses and time.
    bool depends_on_velocities() const { return depends_on_velocities_; }

private:
    void add_spring(const Spring& spring);
    void add_force(const AppliedForce& force, double now);
    void push(int body, const Vector3d& force, const Vector3d& point);

    const World& world_;
    std::span<const int> bodies_;
    std::span<const Wrench> supports_;
    bool depends_on_velocities_ = false;
    std::vector<int> driven_;                     // driven bodies to which a spring is attached
    std::vector<Motion> motions_;                 // one for each body of the world
    std::vector<std::vector<PointForce>> forces_; // one list for each body of the world
    std::vector<Vector3d> torques_;               // one for each body of the world [N m]
    std::vector<Wrench> net_;
};

} // namespace rigor
