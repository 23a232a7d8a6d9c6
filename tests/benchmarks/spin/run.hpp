// SPDX-License-Identifier: MIT
// The scene of `bench spin`, which each engine can run: a free box of 1 × 2 × 3 m and 12 kg that
// starts with ω = (1, 2, 3) rad/s and rotates for 10 s.
#pragma once

#include <Eigen/Dense>

namespace rigor {

inline constexpr double spin_end = 10;                // [s]
inline constexpr double spin_mass = 12;               // [kg]
inline const Eigen::Vector3d spin_size(1, 2, 3);      // [m]
inline const Eigen::Vector3d spin_inertia(13, 10, 5); // [kg m²]
inline const Eigen::Vector3d spin_velocity(1, 2, 3);  // [rad/s]

struct SpinRun {
    double seconds = 0; // time of all steps together; setup is not counted
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

/// The other engines with their default settings, but without gravity, damping and sleep.
SpinRun spin_bullet(int steps);
SpinRun spin_ode(int steps);

} // namespace rigor
