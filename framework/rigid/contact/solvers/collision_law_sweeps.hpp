// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// Sweeps by the formulas of topic `collision`. `collision_impulse` with ε = 0 answers for the velocity
/// that is left when the contact's own impulse is taken back, with a K that does not couple normal and
/// tangent, K̃ = (nᵀKn) n nᵀ + λ (δ - n nᵀ). For sticking the fixed point is the same. For sliding,
/// friction is then opposite to the velocity at the end of the step, so that a block on an incline
/// slides with g (sin θ - μ cos θ) to rounding and does not turn.
std::unique_ptr<Sweeps> collision_law_sweeps(ContactProblem& problem,
                                             std::span<const int> active);

} // namespace rigor
