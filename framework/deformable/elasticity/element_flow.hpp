// SPDX-License-Identifier: MIT
// The linearized plastic flow of an element, for the linear system of an implicit step.
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// The plastic flow of one element, linearized about a guess of its strain at the end of the step.
/// A strain d within the step gives the element the trial stress σ₀ + C d, where σ₀ is its stress
/// at the start of the step and C the elastic stiffness. The flow reduces this stress by
///
///     P + 2 G (a (dev d - (k : d) k) + (n : d) n).
///
/// Radial return along a direction m with ‖m‖ = 1 leaves a share θ of the stress deviator. For this
/// return, a = 1 - θ, n = √θ m and k = 0. The shear stiffness is then 2 G θ for strains
/// perpendicular to m, and 0 for strains along m: the consistent tangent (Simo and Taylor 1985,
/// "Consistent tangent operators for rate-independent elastoplasticity"). If the plastic strain has
/// reached its limit, only a part of it is kept (flow.hpp). Then a and n are smaller, k is the
/// direction of the plastic strain, and n is perpendicular to k. All tensors are in the element's
/// rest space.
struct ElementFlow {
    int element = 0;
    double softened = 0;                // a in the formula above, 0 … 1
    Matrix3d along = Matrix3d::Zero();  // n in the formula above, Tr n = 0
    Matrix3d kept = Matrix3d::Zero();   // k in the formula above, Tr k = 0
    Matrix3d stress = Matrix3d::Zero(); // P, which makes the formula exact at the guess [Pa]
    Matrix3d strain = Matrix3d::Zero(); // d at the guess, about which the flow is linearized
    bool is_limited() const { return !kept.isZero(0); }
};

} // namespace rigor
