// SPDX-License-Identifier: MIT
// Implicit integration of the nodes.
#pragma once

#include "deformable/motion/node_motion.hpp"

namespace rigor {

/// Backward Euler: one linear system for the velocities, then x += h v. In this system, contacts
/// tie nodes to surfaces. An active-set method finds which contacts hold their nodes, and whether
/// these nodes stick or slide. The number of its rounds is limited, also of those that follow each
/// time that the plastic flow is linearized.
void move_implicitly(const NodeMotion& motion);

} // namespace rigor
