// SPDX-License-Identifier: MIT
// Plastic flow of the elements of a solid.
#pragma once

#include "deformable/elasticity/element_workspace.hpp"

namespace rigor {

/// How the elements of a solid yield and flow: by the formulas of topic `plasticity`, with two
/// limits. ‖ε_p‖ stays at most 0.8, and an inverted element does not flow, so that its elastic
/// stress can turn it back.
class FlowRule {
public:
    FlowRule(const Deformable& solid, const Settings& settings);

    /// The plastic strain after the flow of an element.
    struct Flowed {
        bool flows = false;      // whether it yields; if not, its plastic strain stays as it is
        Matrix3d asked;          // the ε_p that the formula returned
        double share = 1;        // the share of `asked` that the limit of ‖ε_p‖ leaves
        Matrix3d plastic_strain; // ε_p after the flow, `share` times `asked`
    };
    /// @param plastic  ε_p before the flow
    /// @param elastic  the trial strain, ε - ε_p with the total strain at the end of the step
    Flowed flowed(const Matrix3d& plastic, const Matrix3d& elastic) const;

private:
    const Deformable* solid_;
    double lambda_, G_, yield_stress_;
    bool is_optimised_; // whether the strain is compared with `bound_`, without the test's formula
    double bound_;      // yield strain, if `is_optimised_`
};

/// Plastic flow of each element that yields, by `plastic_flow`. For all others only the yield test
/// is done.
///
/// @param work  contains the strains at the end of the step; flow updates their elastic parts
void flow(Deformable& solid, ElementWorkspace& work, const Settings& settings, Counters& counters);

} // namespace rigor
