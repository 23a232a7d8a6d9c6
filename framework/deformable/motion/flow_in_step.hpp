// SPDX-License-Identifier: MIT
// The plastic flow within an implicit step.
#pragma once

#include "deformable/elasticity/element_flow.hpp"
#include "deformable/elasticity/flow.hpp"
#include "deformable/motion/velocity_system.hpp"

#include <optional>

namespace rigor {

/// Newton's method for the plastic flow within one implicit step. The stress at the end of a step
/// is the stress after the flow, so it depends on the velocities that the step solves for. Each
/// round linearizes the flow of each element about the velocities of the latest solve. The plastic
/// strains of the solid do not change here; the function `flow` changes them once the nodes have
/// moved.
class FlowInStep {
public:
    /// Begins a step, in which no element has flowed yet.
    ///
    /// @param work  contains the strains at the start of the step
    void start(const Deformable& solid, const ElementWorkspace& work, const Settings& settings,
               double time_step);

    /// Compares the flow of each element with the flow that the latest solve has assumed. If they
    /// differ for any element, linearizes the flow again and puts it into the system. If the
    /// velocities of the solve overshoot (see `backtrack`), it first moves them back.
    ///
    /// @return whether any element differs, so that the system has to be solved again
    bool revise(VelocitySystem& system);

    /// The elements whose flow differs from the flow that the latest solve had assumed.
    const std::vector<int>& changed() const { return changed_; }

private:
    void linearise(const std::vector<Vector3d>& velocities);
    void note_error(int element, const Matrix3d& error, const Matrix3d& trial, const Matrix3d& d,
                    const ElementFlow* solved);
    bool backtrack(VelocitySystem& system);
    void apply(VelocitySystem& system);
    Matrix3d relaxed_stress(const Matrix3d& flow) const;
    Matrix3d strain_in_step(int element, const std::vector<Vector3d>& velocities) const;

    const Deformable* solid_ = nullptr;
    const ElementWorkspace* work_ = nullptr;
    std::optional<FlowRule> rule_;
    double time_step_ = 0, lambda_ = 0, G_ = 0; // h [s], λ, G [Pa]
    bool is_first_ = true;                      // no flow has been linearized in this step yet
    std::vector<Vector3d> elastic_momenta_;     // right-hand side of the system without flow [N s]
    std::vector<Vector3d> guess_; // the velocities that the flow was linearized about [m/s]
    // The linearized flow in the latest solve, and in the next one; sorted by element.
    std::vector<ElementFlow> flows_, next_;
    std::vector<int> changed_;
    // Slope of the minimized function along `way_` at the latest velocities [J]; > 0 beyond the
    // minimum.
    double slope_beyond_ = 0;
    std::vector<Vector3d> way_; // from `guess_` to the latest velocities [m/s]
};

} // namespace rigor
