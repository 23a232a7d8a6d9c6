// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Whether the impulses of an island are far from the law of contact: whether they change the
/// velocities far more than was to be expected, or show that the law needs such a change. In a jam,
/// where driven bodies close in on a body between them, no motion obeys the law. There the impulses
/// grow without end, also by methods that converge elsewhere.
///
/// The impulses j change the velocities by Δv = M⁻¹ Jᵀ j (M: mass matrix, J v: relative velocities
/// at the contacts). Let v be the velocities after that, s the target speeds, and |Δv|² = Δvᵀ M Δv.
/// Without friction, all velocities v* with vₙ* ≥ s at each contact differ from the velocities
/// v - Δv before the impulses by at least
///
///     |v* - (v - Δv)| ≥ |Δv| + Σ jₙ (s - vₙ)/|Δv|
///
/// because Σ jₙ (s - vₙ) ≤ Σ jₙ (vₙ* - vₙ) = Δvᵀ M (v* - v) ≤ |Δv| |v* - v + Δv| - |Δv|². For the
/// solution the bound is its own |Δv|, since vₙ = s wherever jₙ > 0. In a jam there is no v*: the
/// impulses come to balance each other while s - vₙ stays above 0, and the bound grows without
/// limit (Farkas 1902, "Theorie der einfachen Ungleichungen", J. reine angew. Math. 124).
///
/// @param active    indices in `problem.contacts`; `problem.bodies` have the velocities v
/// @param impulses  impulses j on body 1 of the active contacts [N s]
/// @param approach  the largest s - vₙ of a contact before the impulses [m/s]
/// @return whether |Δv| or the bound is a large multiple of √M a. M is the mass of the island here.
///         If driven bodies push, a is the approach; if all bodies may rest, it is the highest
///         speed |v - s n| of a contact before the impulses.
bool is_far_from_law(const ContactProblem& problem, const Island& island,
                     std::span<const int> active, const std::vector<Vector3d>& impulses,
                     double approach);

} // namespace rigor
