// SPDX-License-Identifier: MIT
// The stable time step of explicit integration.
#pragma once

#include "deformable/elasticity/elements.hpp"

namespace rigor {

/// A lower bound of the longest substep for which symplectic Euler is stable near rest [s]:
///
///     h = √(β² + 4/ω²) - β,    ω² ≤ max over the elements of the largest eigenvalue of M_e⁻¹ K_e
///
/// Here β is the damping and ω the highest frequency; h is computed with the bound in place of ω².
/// As vᵀ K v = Σ vₑᵀ Kₑ vₑ ≤ max λₑ Σ vₑᵀ Mₑ vₑ, with the largest eigenvalue λₑ of an element, the
/// bound holds for any way to share a node's mass among its elements (Irons and Treharne 1971).
/// Each element gets a share in proportion to its V |∇N|². So a stiff element gets more mass, and a
/// sliver beside large elements does not determine the step alone.
double stable_step(const Deformable& solid, const Elements& elements);

} // namespace rigor
