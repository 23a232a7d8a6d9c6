// SPDX-License-Identifier: MIT
#pragma once

#include "deformable/contact/node_contacts.hpp"

namespace rigor {

/// Nodes that would be inside a body after `time_step` get the impulse of a collision, and the bodies
/// its opposite: `collision_impulse` with K = δ/m + K of the body. With restitution, before the forces of
/// a substep; without, after them: then a gap that is left may close within the substep.
void collide_nodes(Deformable& solid, const std::vector<char>& is_held,
                   const NodeContacts& contacts, RigidColliders& rigid, double time_step,
                   bool with_restitution, Counters& counters);

/// Moves nodes out of bodies, without a velocity: by a fifth of their depth a step, and no faster than
/// the solid's radius a second.
void correct_positions(Deformable& solid, const std::vector<char>& is_held,
                       const NodeContacts& contacts, double step_share, double farthest);

} // namespace rigor
