// SPDX-License-Identifier: MIT
// Impulses and position correction at the contacts of nodes.
#pragma once

#include "deformable/contact/held_axes.hpp"
#include "deformable/contact/node_contacts.hpp"

namespace rigor {

/// Applies a collision impulse to each node that would be inside a body after `time_step`, and the
/// opposite impulse to the body. The impulse is `collision_impulse` with K = F/m + K_b, where m is
/// the mass of the node, F the projector on the coordinates that no handle prescribes (the unit
/// matrix for most nodes), and K_b the `impulse_matrix` of the body.
///
///   * With restitution, only contacts that rebound get an impulse. A contact does not rebound if
///     its restitution is 0, or if gravity would stop the rebound within two time steps.
///   * Without restitution, a node may still close its gap within the time step.
///
/// A substep of explicit integration calls this function twice: with restitution when half of the
/// forces have acted, and without when all have. An implicit step calls it once, with restitution.
void collide_nodes(Deformable& solid, const std::vector<HeldAxes>& held,
                   const NodeContacts& contacts, RigidColliders& rigid, double time_step,
                   bool with_restitution, Counters& counters);

/// Pushes rigid bodies away from nodes that handles keep from moving along the contact normal. An
/// implicit step calls this function after the solve for the velocities of the nodes. The method is
/// sequential impulses with Coulomb's law (Catto 2005, "Iterative dynamics with temporal
/// coherence"). If a node is inside a body, the body is moved away by a share of the penetration in
/// each step.
void push_by_held_nodes(const Deformable& solid, const std::vector<HeldAxes>& held,
                        const NodeContacts& contacts, RigidColliders& rigid, double time_step,
                        Counters& counters);

/// Position correction: moves nodes that are inside rigid bodies outwards, along the coordinates
/// that no handle prescribes, without changing velocities. The penetration is that of the latest
/// `NodeContacts::measure`, before the nodes moved.
///
/// @param step_share  length of the substep divided by that of the step; a whole step removes about
///                    a fifth of the penetration
/// @param farthest    the largest correction along the normal for one contact [m]
void correct_node_positions(Deformable& solid, const std::vector<HeldAxes>& held,
                            const NodeContacts& contacts, double step_share, double farthest);

} // namespace rigor
