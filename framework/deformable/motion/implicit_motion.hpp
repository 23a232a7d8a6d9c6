// SPDX-License-Identifier: MIT
// Implicit integration of the nodes.
#pragma once

#include "deformable/motion/node_motion.hpp"

namespace rigor {

/// Backward Euler: one linear system for the velocities, then x += h v. Contacts tie nodes to
/// surfaces in the system itself. Which of them hold, stick or slide is found by an active-set
/// method, in at most ten rounds.
void move_implicitly(const NodeMotion& motion);

} // namespace rigor
