// SPDX-License-Identifier: MIT
// Motion of the nodes of a solid as one rigid body, by the formulas of the lecture's section
// "Constrained dynamics" (assignment A1).
#pragma once

#include "deformable/motion/node_motion.hpp"

namespace rigor {

/// A step in the six velocity modes. S maps u = (V, ω) to the velocity of a node, and F is the
/// force on each node. From (Sᵀ M S) u̇ + (Sᵀ M Ṡ) u = Sᵀ F follows u̇, and each node moves by
/// x += h S u + ½ h² (S u̇ + Ṡ u). The inner forces of the solid have no effect. Gravity and loads
/// act; drag, handles and contacts do not.
void move_in_modes(const NodeMotion& motion);

/// A step in which the modes accelerate as in `move_in_modes`, but the nodes move by the formula
/// `advance_matrix`. The matrix that this formula returns is not corrected to a rotation, so that
/// the solid grows.
void move_by_matrix(const NodeMotion& motion);

} // namespace rigor
