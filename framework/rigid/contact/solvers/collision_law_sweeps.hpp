// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// Sweeps by the formula `collision_impulse`. For each contact, the formula gets ε = 0 and the
/// relative velocity without the effect of this contact's current impulse, minus the target speed
/// times n. Instead of K it gets the matrix K̃ = (nᵀKn) n nᵀ + λ (δ - n nᵀ), where n is the normal,
/// δ the identity and λ the larger eigenvalue of K in the tangent plane. Unlike K, the matrix K̃
/// never couples the normal and the tangential direction. For a sticking contact, the sweeps
/// converge to the same impulse with K̃ as with K. For a sliding contact, friction is opposite to
/// the velocity at the end of the step. So a block on an incline (θ: its angle, μ: friction
/// coefficient) slides with the acceleration g (sin θ - μ cos θ) up to rounding and does not turn.
std::unique_ptr<Sweeps> collision_law_sweeps(ContactProblem& problem, std::span<const int> active);

} // namespace rigor
