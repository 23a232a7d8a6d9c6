// SPDX-License-Identifier: MIT
// Explicit integration of the nodes.
#pragma once

#include "deformable/motion/node_motion.hpp"

namespace rigor {

/// Symplectic Euler in stable substeps h: v += h f(x, v)/m, then x += h v. Between the two, drag
/// divides v by 1 + α h (α: `SolidMaterial::drag`). In each substep, nodes also bounce and get
/// contact impulses, follow their handles and are moved out of rigid bodies. Last, the elements
/// flow plastically, unless the solid flows only after each step (`flows_in_step`).
void move_explicitly(const NodeMotion& motion);

} // namespace rigor
