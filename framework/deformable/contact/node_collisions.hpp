// SPDX-License-Identifier: MIT
// Impulses and position correction at the contacts of nodes.
#pragma once

#include "deformable/contact/node_contacts.hpp"

namespace rigor {

/// Applies a collision impulse to each node that would be inside a body after `time_step`, and the
/// opposite impulse to the body: `collision_impulse` with K = δ/m + K_b, where δ is the unit
/// matrix, m the mass of the node and K_b the `impulse_matrix` of the body. A substep calls it
/// twice: before the forces with restitution, after them without. In the second call a remaining
/// gap may close within the substep.
void collide_nodes(Deformable& solid, const std::vector<char>& is_held,
                   const NodeContacts& contacts, RigidColliders& rigid, double time_step,
                   bool with_restitution, Counters& counters);

/// Position correction: moves nodes that are inside bodies outwards, without changing velocities.
///
/// @param step_share  substep divided by step; a whole step removes a fifth of the penetration
/// @param farthest    the largest correction [m]
void correct_node_positions(Deformable& solid, const std::vector<char>& is_held,
                            const NodeContacts& contacts, double step_share, double farthest);

} // namespace rigor
