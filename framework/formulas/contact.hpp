// SPDX-License-Identifier: MIT
// Topic `contact`, assignment A5: many contact points, many bodies, stacks.
// Source: lecture "Inertia, rotation, impulses", "Rigid collision algorithms"; Guendelman, Bridson
// and Fedkiw (2003), "Nonconvex rigid bodies with stacking". Conventions: types.hpp. Everything is
// in world space; n points from body 2 to body 1; v = v1 - v2 at the contact's point; body 1
// receives +j, body 2 receives -j.
//
// A contact requires v·n ≥ s with its `separation_speed` s. So the law of a contact uses
// u = v - s n instead of v: the bodies approach where u·n < 0. Contacts refer to bodies by index. A
// list may have tens of thousands of bodies or contacts.
#pragma once

#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"

namespace rigor {

/// A5.1 Restitution of iteration k = 0 … n-1 of n: ε = (k + 1)/n - 1, from nearly -1 up to 0.
/// Guendelman et al. (2003) take n = 10, which gives -0.9, -0.8, … 0.
///
/// A negative restitution removes only a part of the approaching velocity, so that the first
/// contact point does not take the whole load. k < 0 counts as 0. The result is 0 for k ≥ n - 1 and
/// for n < 1.
double contact_restitution(int k, int n);

/// A5.2 Contacts resolved one at a time, the deepest first, in n iterations with increasing
/// restitution.
///
/// Iteration k visits each contact once, in order of depth, the deepest first (of equal depths, the
/// one that comes first in `contacts`). If the bodies of a contact approach at that moment,
/// u·n < 0, the contact gets the impulse `collision_impulse(K, u, n, ε, μ)` with
/// ε = `contact_restitution(k, n)`. Both bodies have their new velocities before the next contact
/// is visited. The field `impulse` of the contacts is not used.
///
/// @return  the bodies afterwards, and for each contact the sum of its impulses. For n < 1 the
///          bodies are unchanged.
ContactResult resolve_contacts(const std::vector<Body>& bodies,
                               const std::vector<BodyContact>& contacts, int n);

/// A5.3 The level of each body: its height above the ground, counted in bodies.
///
/// A static body has level 0. The level of any other body is one more than the highest level among
/// the bodies that it rests on (1 if it rests on nothing). Bodies that rest on each other in a
/// cycle share one level, which is one more than the highest level among the other bodies that
/// any of them rests on. What a static body rests on is ignored, so no cycle contains a static
/// body.
///
/// @param rests_on   for each body, the indices of the bodies that it rests on; an index may
///                   repeat, and may be that of the body itself
/// @param is_static  for each body, whether it is static
std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static);

/// A5.4 Contacts resolved level by level, from the ground up, so that the weight of the upper
/// bodies cannot push the lower ones into each other: "shock propagation".
///
/// For each level ℓ = 1, 2, … the contacts whose higher body has level ℓ are resolved as in
/// `resolve_contacts` with n iterations. Meanwhile every body of a level below ℓ is held: it keeps
/// its velocity as if its mass and inertia were infinite. Contacts between two bodies of level 0
/// are skipped.
///
/// @param levels  one for each body, from 0 to a million, such as `contact_levels` returns; there
///                may be levels without a body between those of two bodies; a body of level 0 need
///                not be a static body, and a static body may have a higher level
/// @return  the bodies afterwards, each with its own mass and inertia again, and for each contact
///          the sum of its impulses on body 1, including those that a held body did not receive
ContactResult shock_propagation(const std::vector<Body>& bodies,
                                const std::vector<BodyContact>& contacts,
                                const std::vector<int>& levels, int n);

/// A5.5 All contacts resolved at once, by sweeps of projected Gauss–Seidel on the friction-cone
/// problem.
/// Source: Jean (1999), "The non-smooth contact dynamics method"; Erleben (2007), "Velocity-based
/// shock propagation for multibody dynamics animation".
///
/// First the `impulse` of every contact (the warm start) is applied to its bodies. Then each sweep
/// visits the contacts in the order given. With the velocity v at that moment and the contact's
/// `separation_speed` s, its total impulse j is updated:
///
///     jₙ ← max(0, jₙ - (v·n - s) / (nᵀ K n))
///     j_T ← j_T - v_T / λ,  shortened to |j_T| = μ jₙ where it is longer
///
/// Here λ is the larger eigenvalue of K perpendicular to n (that of P K P with P = δ - n nᵀ), and
/// jₙ on the second line is the new one, while v is the same on both lines. The bodies receive the
/// difference of the impulses at once.
/// Where the sweeps converge, all contacts satisfy their laws at the same time: jₙ ≥ 0 and v·n ≥ s,
/// at least one of the two with equality, and |j_T| ≤ μ jₙ. Where v_T ≠ 0, |j_T| = μ jₙ and j_T is
/// opposite to v_T.
///
/// @return  the bodies afterwards, and for each contact its total impulse. For sweeps < 1, the warm
///          start alone. A contact between two static bodies always has zero impulse.
ContactResult resolve_simultaneously(const std::vector<Body>& bodies,
                                     const std::vector<BodyContact>& contacts, int sweeps);

} // namespace rigor
