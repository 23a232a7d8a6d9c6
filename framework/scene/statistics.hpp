// SPDX-License-Identifier: MIT
// Energy, momentum and penetration along a trajectory, by the framework's own algebra: no formula
// of an assignment is called, so that a wrong one cannot hide.
#pragma once

#include "scene/trajectory.hpp"

namespace rigor {

/// Sums over the bodies that move.
struct FrameStatistics {
    double time = 0;                              // [s]
    double kinetic_energy = 0;                    // [J]
    double potential_energy = 0;                  // of gravity and springs [J]
    Vector3d momentum = Vector3d::Zero();         // [kg m/s]
    Vector3d angular_momentum = Vector3d::Zero(); // about the world's origin [kg m²/s]
    double deepest_penetration = 0;               // of the recorded contacts [m]
    double total_energy() const { return kinetic_energy + potential_energy; }
};

class Statistics {
public:
    Statistics(const Scene& scene, const std::vector<RecordedBody>& bodies);

    FrameStatistics of(const Frame& frame) const;

    /// ω = I(t)⁻¹ L of a body [rad/s]; zero about axes without inertia, and for static bodies.
    Vector3d angular_velocity(std::size_t body, const RigidState& state) const;

private:
    Scene scene_;
    std::vector<RecordedBody> bodies_;
    std::vector<Matrix3d> inverse_inertia_; // object space
};

} // namespace rigor
