// SPDX-License-Identifier: MIT
// The exact motion of a rigid body that no torque acts on, by Jacobi's elliptic functions.
#pragma once

#include <Eigen/Dense>

namespace rigor {

/// A body with three different moments, whose principal axes are the axes of object space.
///
/// The angular velocity is Jacobi's solution of Euler's equations (Landau and Lifshitz,
/// "Mechanics", § 37). For the orientation, the axis 3, about which L circles in object space,
/// precesses about L in world space at the rate
///     φ̇ = |L| (2E - I₃ω₃²) / (|L|² - I₃²ω₃²),
/// with the kinetic energy E. The rate is smooth and periodic, so that Gauss–Legendre quadrature is
/// exact up to rounding.
class FreeRotor {
public:
    /// @param moments           principal moments, all different [kg m²]
    /// @param angular_velocity  ω at t = 0, where object space and world space coincide [rad/s];
    ///                          not about a principal axis
    FreeRotor(const Eigen::Vector3d& moments, const Eigen::Vector3d& angular_velocity);

    /// ω in object space [rad/s].
    Eigen::Vector3d body_angular_velocity(double t) const;

    /// The rotation from object space to world space; the identity at t = 0.
    Eigen::Quaterniond orientation(double t) const;

    /// The time after which the angular velocity repeats [s].
    double period() const { return period_; }

private:
    Eigen::Matrix3d triad(double t) const;
    double precession(double t) const;

    Eigen::Vector3d moments_, L_;
    // Axes 1, 2, 3 of Landau and Lifshitz; in object space L circles about axis 3.
    int axis1_ = 0, axis2_ = 1, axis3_ = 2;
    double amplitude1_ = 0, amplitude2_ = 0, amplitude3_ = 0;
    double rate_ = 0, phase_ = 0, modulus_squared_ = 0, period_ = 0, energy_twice_ = 0;
};

/// Angle of the rotation between two orientations [rad]. It uses atan2, since acos cannot resolve
/// angles below 2e-8.
double rotation_angle(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

} // namespace rigor
