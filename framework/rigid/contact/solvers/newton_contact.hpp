// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Computes the impulses of a whole island at once, where sweeps converge too slowly: in tall
/// stacks, for heavy bodies on light ones, for friction at its limit. The method is the augmented
/// Lagrangian method (Alart and Curnier 1991, "A mixed formulation for frictional contact problems
/// prone to Newton like solution methods", Comput. Methods Appl. Mech. Eng. 92). Each contact has
/// the velocity error u = J v - s (v: the velocities of all bodies, J v: the relative velocity of
/// the contact, s: its target), the impulse j and a penalty ρ. The method iterates
///
///     j ← P(j - ρ u(v))   where   M (v - v_free) = Jᵀ P(j - ρ u(v))
///
/// where M is the mass matrix and v_free are the velocities before the contact stage. P makes the
/// normal part non-negative and shortens the tangential part to the friction limit μ jₙ if it is
/// longer. As long as the friction limit is held fixed, the solution v of the second equation is
/// the minimum of a convex function, which Newton's method with a line search finds. Its linear
/// system is sparse, with 6 unknowns for each body, and is solved by a Cholesky factorization. The
/// time that this takes depends on which bodies touch, not on their masses. With a very large mass
/// ratio, the method only needs a few more rounds, because the penalty has to grow further. The
/// caller checks the result by further sweeps (island_solver.hpp).
///
/// @param free      the bodies of the island before the contact stage gives them an impulse, in the
///                  order of `island.bodies`
/// @param active    indices in `problem.contacts`
/// @param impulses  impulses on body 1 of the active contacts [N s]; the caller passes those from
///                  which the method starts, and gets the result
/// @return  whether the method succeeded; if not, the caller must not use the impulses
bool newton_impulses(const ContactProblem& problem, const Island& island,
                     const std::vector<Body>& free, std::span<const int> active,
                     std::vector<Vector3d>& impulses);

} // namespace rigor
