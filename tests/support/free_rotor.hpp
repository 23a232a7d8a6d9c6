// SPDX-License-Identifier: MIT
// The exact motion of a rigid body that no torque acts on, by Jacobi's elliptic functions.
#pragma once

#include <Eigen/Dense>

namespace rigor {

/// A body with three different moments, its principal axes along object space's.
///
/// The angular velocity is Jacobi's solution of Euler's equations (Landau and Lifshitz, "Mechanics",
/// § 37). For the orientation, the axis that L never leaves precesses about L at the rate
///     φ̇ = |L| (2E - I₃ω₃²) / (|L|² - I₃²ω₃²),
/// which is smooth and periodic: Gauss–Legendre quadrature takes it to rounding.
class FreeRotor {
public:
    /// @param moments           different from each other [kg m²]
    /// @param angular_velocity  at t = 0, in object space = world space; about no principal axis alone
    FreeRotor(const Eigen::Vector3d& moments, const Eigen::Vector3d& angular_velocity);

    /// ω in object space [rad/s].
    Eigen::Vector3d body_angular_velocity(double t) const;

    /// Object space to world space; the identity at t = 0.
    Eigen::Quaterniond orientation(double t) const;

    /// After which the angular velocity repeats [s].
    double period() const { return period_; }

private:
    Eigen::Matrix3d triad(double t) const;
    double precession(double t) const;

    Eigen::Vector3d moments_, L_;
    int axis1_ = 0, axis2_ = 1, axis3_ = 2; // Landau's 1, 2, 3; L circles about 3
    double amplitude1_ = 0, amplitude2_ = 0, amplitude3_ = 0;
    double rate_ = 0, phase_ = 0, modulus_squared_ = 0, period_ = 0, energy_twice_ = 0;
};

/// Angle of the rotation between two orientations [rad]. With atan2: acos cannot see below 2e-8.
double rotation_angle(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

} // namespace rigor
