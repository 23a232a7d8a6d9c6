// SPDX-License-Identifier: MIT
#pragma once

#include "deformable/motion/node_motion.hpp"

namespace rigor {

/// Backward Euler: one linear system for the velocities, then x += h v. Contacts tie nodes to surfaces
/// in the system itself; which of them hold, stick or slide is found by trying (an active set), at most
/// ten times.
void move_implicitly(const NodeMotion& motion);

} // namespace rigor
