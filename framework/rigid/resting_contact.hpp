// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact_problem.hpp"

namespace rigor {

/// The third stage of the 2003 time step: after the forces, contacts hold. No restitution.
///
/// Each contact in turn, over and over, gets the impulse that the collision law gives it when all
/// the others are in place (block Gauss–Seidel): its own is taken back, `collision_impulse` with ε = 0
/// answers for the velocity that leaves, and the difference is applied. So impulses never pull in
/// total, though a correction may. The normal velocity that is asked for is -gap/h where there is a
/// gap: to touch at the end of the step, not before; and `recovery` where there is a penetration.
///
/// The law is asked with K freed of its coupling between normal and tangent,
/// K̃ = (nᵀKn) n nᵀ + λ (δ - n nᵀ), λ the larger eigenvalue of the tangential part. The fixed point is
/// the same for sticking; for sliding, friction is then opposite to the velocity at the end of the
/// step, so that a block on an incline slides with g (sin θ - μ cos θ) to rounding and does not turn.
///
/// Sweeps start from `guess_loads`, run from the lowest contact up and are sped up by the nonsmooth
/// nonlinear conjugate gradient method (Silcowitz-Hansen, Niebe and Erleben 2010, "A nonsmooth nonlinear
/// conjugate gradient method for interactive contact force problems", Visual Computer 26). A small
/// island converges to rounding; a large one to a thousandth, or until it had its share of work.
void process_contact(ContactProblem& problem, const Island& island);

} // namespace rigor
