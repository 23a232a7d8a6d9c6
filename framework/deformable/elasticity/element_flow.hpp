// SPDX-License-Identifier: MIT
// The flow of an element within a step, as the linear system of the step knows it.
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// The flow of one element, linearised about a guess of its strain at the end of the step. By a
/// strain d within the step, the element gets the trial stress σ₀ + C d. Its flow takes from that
///
///     P + 2 G (a (dev d - (k : d) k) + (n : d) n).
///
/// Radial return by a direction of norm 1 that leaves the share θ of the deviator has a = 1 - θ,
/// n = √θ times this direction and k = 0. What is left of 2 G in the stiffness is then 2 G θ across
/// n, and nothing along n: the consistent tangent (Simo and Taylor 1985, "Consistent tangent
/// operators for rate-independent elastoplasticity"). If the plastic strain has reached its limit,
/// its own direction is k, and n is across it. All are in the element's rest space.
struct ElementFlow {
    int element = 0;
    double softened = 0;                // a, 0 … 1
    Matrix3d along = Matrix3d::Zero();  // n, Tr n = 0
    Matrix3d kept = Matrix3d::Zero();   // k, Tr k = 0
    Matrix3d stress = Matrix3d::Zero(); // P [Pa]
    Matrix3d strain = Matrix3d::Zero(); // d of the guess
    bool is_limited() const { return !kept.isZero(0); }
};

} // namespace rigor
