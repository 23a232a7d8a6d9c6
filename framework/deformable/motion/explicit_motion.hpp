// SPDX-License-Identifier: MIT
// Explicit integration of the nodes.
#pragma once

#include "deformable/motion/node_motion.hpp"

namespace rigor {

/// Symplectic Euler in stable substeps h: v += h f(x, v)/m, then x += h v. Between the two, drag
/// divides v by 1 + α h.
void move_explicitly(const NodeMotion& motion);

} // namespace rigor
