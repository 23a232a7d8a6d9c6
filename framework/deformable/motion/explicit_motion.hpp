// SPDX-License-Identifier: MIT
// Explicit integration of the nodes.
#pragma once

#include "deformable/motion/node_motion.hpp"

namespace rigor {

/// Symplectic Euler in stable substeps: v += h f(x, v)/m, then x += h v. Drag replaces v by
/// v/(1 + α h).
void move_explicitly(const NodeMotion& motion);

} // namespace rigor
