// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// The impulses of a whole island at once, where sweeps get nowhere: tall stacks, heavy bodies on
/// light ones, friction at its limit. The augmented Lagrangian method (Alart and Curnier 1991, "A mixed
/// formulation for frictional contact problems prone to Newton like solution methods", Comput. Methods
/// Appl. Mech. Eng. 92): with u = J v - s and a weight ρ for each contact,
///
///     λ ← P(λ - ρ u(v))   where   M (v - v_free) = Jᵀ P(λ - ρ u(v))
///
/// and P makes the normal part not negative and shortens the tangential one to μ λₙ. The equation for
/// v is the minimum of a convex function as long as the friction's limit is held, and Newton's method
/// with a line search finds it: a sparse system with 6 unknowns a body, which no chain of bodies and no
/// ratio of masses makes hard. Whatever this gives, the sweeps go on from there and judge it.
///
/// @param free      the bodies of the island, in its order, without the impulses
/// @param active    indices of the contacts in the problem
/// @param impulses  on body 1, of the active contacts: the start, and then the result [N s]
/// @return  whether it got anywhere; if not, the impulses are as they were
bool newton_impulses(const ContactProblem& problem, const Island& island,
                     const std::vector<Body>& free, std::span<const int> active,
                     std::vector<Vector3d>& impulses);

} // namespace rigor
