// SPDX-License-Identifier: MIT
// Energy, momentum and penetration along a trajectory. They are computed from the recorded states
// without formulas of the assignments, so that the error of a wrong formula stays visible. The
// totals of a deformable solid are taken from the trajectory; its elastic energy there was computed
// with the formula `isotropic_stress`.
#pragma once

#include "deformable/elasticity/totals.hpp"
#include "scene/trajectory/trajectory.hpp"

namespace rigor {

/// A deformable solid at one moment.
struct SolidStatistics {
    DeformableTotals totals;
    std::size_t pieces = 0, elements = 0;
    double largest_stress = 0;         // von Mises stress of an element [Pa]
    double largest_plastic_strain = 0; // equivalent strain of an element, no unit
};

/// Sums over the rigid bodies that are not static, and over the deformable solids.
struct FrameStatistics {
    double time = 0;                              // [s]
    double kinetic_energy = 0;                    // [J]
    double potential_energy = 0;                  // gravity, springs and elastic solids [J]
    Vector3d momentum = Vector3d::Zero();         // [kg m/s]
    Vector3d angular_momentum = Vector3d::Zero(); // about the world's origin [kg m²/s]
    double deepest_penetration = 0;               // among the recorded contacts [m]
    std::vector<SolidStatistics> solids;          // one for each deformable solid
    double total_energy() const { return kinetic_energy + potential_energy; }
};

SolidStatistics statistics_of(const SolidFrame& solid);

class Statistics {
public:
    Statistics(const Scene& scene, const std::vector<RecordedBody>& bodies);

    FrameStatistics of(const Frame& frame) const;

    /// ω = I(t)⁻¹ L of a body [rad/s]. It is zero about axes whose moment of inertia is 0, and
    /// for static bodies.
    Vector3d angular_velocity(std::size_t body, const RigidState& state) const;

private:
    Scene scene_;
    std::vector<RecordedBody> bodies_;
    std::vector<Matrix3d> inverse_inertia_; // object space
};

} // namespace rigor
