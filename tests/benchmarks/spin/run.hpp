// SPDX-License-Identifier: MIT
// The case of `bench spin`, run by whoever can: a free box 1 × 2 × 3 m of 12 kg that starts with
// ω = (1, 2, 3) rad/s and turns for 10 s.
#pragma once

#include <Eigen/Dense>

namespace rigor {

inline constexpr double spin_end = 10;                // [s]
inline constexpr double spin_mass = 12;               // [kg]
inline const Eigen::Vector3d spin_size(1, 2, 3);      // [m]
inline const Eigen::Vector3d spin_inertia(13, 10, 5); // [kg m²]
inline const Eigen::Vector3d spin_velocity(1, 2, 3);  // [rad/s]

struct SpinRun {
    double seconds = 0; // for all steps together; setting up is not counted
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

/// Each with the engine's defaults, no gravity, no damping, no sleep.
SpinRun spin_bullet(int steps);
SpinRun spin_ode(int steps);

} // namespace rigor
