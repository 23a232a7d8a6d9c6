// SPDX-License-Identifier: MIT
// Topic `contact`, assignment A5: many contact points, many bodies, stacks.
// Source: lecture "Inertia, rotation, impulses", "Rigid collision algorithms"; Guendelman, Bridson
// and Fedkiw (2003), "Nonconvex rigid bodies with stacking", sections 7 and 8. Conventions:
// types.hpp. Everything is in world space; n points from body 2 to body 1; v = v1 - v2 at the
// contact's point; body 1 receives +j, body 2 -j.
//
// A contact asks for v·n ≥ s with its `separation_speed` s. So the law of a contact sees
// u = v - s n instead of v: the bodies approach where u·n < 0. Contacts name bodies by their index.
#pragma once

#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"

namespace rigor {

/// A5.1 Restitution of iteration k = 0 … n-1 of n: ε = (k + 1)/n - 1, from nearly -1 up to 0.
/// Paper: section 7.1, where n = 10 gives -0.9, -0.8, … 0.
///
/// A negative restitution takes away only a part of the approaching velocity, so that the first
/// point does not get the whole load. k below 0 counts as 0; k ≥ n - 1, and n < 1, give 0.
double contact_restitution(int k, int n);

/// A5.2 Contacts one point at a time, deepest first, in n iterations of growing restitution.
/// Paper: section 7.1.
///
/// Iteration k visits each contact once, in order of depth, the deepest first (of equal depths the
/// one that comes first). A contact whose bodies approach at that moment, u·n < 0, gets
/// `collision_impulse(K, u, n, ε, μ)` with ε = `contact_restitution(k, n)`; both bodies move on with
/// their new velocities before the next contact is looked at. The contacts' `impulse` is not used.
///
/// @return  the bodies afterwards, and of each contact the sum of its impulses. n < 1: unchanged.
ContactResult resolve_contacts(const std::vector<Body>& bodies,
                               const std::vector<BodyContact>& contacts, int n);

/// A5.3 How high each body stands above the ground, counted in bodies. Paper: section 8.
///
/// A static body has level 0. Any other body has one level more than the highest of those it rests
/// on (1 if it rests on nothing). Bodies that rest on each other in a cycle share one level, one
/// more than the highest of the others that any of them rests on. What a static body rests on does
/// not matter, so no cycle leads through one.
///
/// @param rests_on   of each body, the indices of the bodies that it rests on; an index may repeat,
///                   and may be the body's own
/// @param is_static  of each body
std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static);

/// A5.4 Contacts level by level from the ground up, so that weight cannot press a stack into itself.
/// Paper: section 8, "shock propagation".
///
/// For each level ℓ = 1, 2, … the contacts whose higher body has level ℓ are resolved as in
/// `resolve_contacts` with n iterations, while every body of a level below ℓ is held: it keeps its
/// velocity as if its mass and inertia were infinite. Contacts between two bodies of level 0 are left
/// alone.
///
/// @param levels  of each body, ≥ 0, from `contact_levels`
/// @return  the bodies afterwards, each with its own mass and inertia again, and of each contact the
///          sum of its impulses on body 1 as ever, though a body that was held did not receive them
ContactResult shock_propagation(const std::vector<Body>& bodies,
                                const std::vector<BodyContact>& contacts,
                                const std::vector<int>& levels, int n);

/// A5.5 All contacts at once: sweeps of projected Gauss–Seidel on the friction-cone problem.
/// Source: Jean (1999), "The non-smooth contact dynamics method"; Erleben (2007), "Velocity-based
/// shock propagation for multibody dynamics animation", section 3.
///
/// First every contact's `impulse`, the warm start, acts on its bodies. Then each sweep visits the
/// contacts in the order given. A contact's total impulse j becomes, with the velocity of that
/// moment,
///
///     jₙ ← max(0, jₙ - (v·n - s) / (nᵀ K n))
///     j_T ← j_T - v_T / λ,  shortened to |j_T| = μ jₙ where it is longer
///
/// where λ is the larger eigenvalue of K across n (of P K P with P = δ - n nᵀ), jₙ on the second line
/// is the new one, and the bodies receive the difference at once. Where the sweeps converge, all
/// contacts obey their laws at the same time: jₙ ≥ 0, v·n ≥ s, one of the two with equality, and
/// |j_T| ≤ μ jₙ, where v_T ≠ 0 with equality and j_T against v_T.
///
/// @return  the bodies afterwards, and of each contact its total impulse. sweeps < 1: the warm start
///          alone. A contact between two static bodies: zero impulse.
ContactResult resolve_simultaneously(const std::vector<Body>& bodies,
                                     const std::vector<BodyContact>& contacts, int sweeps);

} // namespace rigor
