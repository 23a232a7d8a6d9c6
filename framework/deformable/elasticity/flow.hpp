// SPDX-License-Identifier: MIT
// Plastic flow of the elements of a solid.
#pragma once

#include "deformable/elasticity/element_workspace.hpp"

namespace rigor {

/// How the elements of a solid yield and flow: by the formulas of topic `plasticity`, with two
/// limits. The norm ‖ε_p‖ of the plastic strain stays at most 0.8, and an inverted element does not
/// flow, so that its elastic stress can turn it back.
class FlowRule {
public:
    FlowRule(const Deformable& solid, const Settings& settings);

    /// The plastic strain ε_p after the flow of an element.
    struct Flowed {
        // Whether the element flows. If not, ε_p stays the same, and the matrices below stay unset.
        bool flows = false;
        Matrix3d asked; // the ε_p that `plastic_flow` returned
        double share = 1; // share of `asked` that is kept, below 1 if ‖`asked`‖ is above the limit
        Matrix3d plastic_strain; // ε_p after the flow, `share` times `asked`
    };
    /// @param plastic  ε_p before the flow
    /// @param elastic  the trial strain: the total strain ε at the end of the step, minus `plastic`
    Flowed flowed(const Matrix3d& plastic, const Matrix3d& elastic) const;

private:
    const Deformable* solid_;
    double lambda_, G_, yield_stress_;
    // Whether this class makes the yield test itself: it compares the strain of each element with
    // `bound_`. For elements that do not yield, it then calls no formula.
    bool is_optimised_;
    double bound_; // the yield strain, if `is_optimised_`
};

/// Plastic flow, by `plastic_flow`, of each element that yields and is not inverted. The other
/// elements keep their plastic strain.
///
/// @param work  contains the strains at the end of the step; this function updates their elastic
///              parts
void flow(Deformable& solid, ElementWorkspace& work, const Settings& settings, Counters& counters);

} // namespace rigor
