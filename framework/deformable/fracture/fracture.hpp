// SPDX-License-Identifier: MIT
#pragma once

#include "deformable/elasticity/element_workspace.hpp"

namespace rigor {

/// Cracks where smoothed stresses pull more than the material bears, the most stressed elements first,
/// at most one at a node and `most_cracks` in a step; then the mesh comes apart.
///
/// No eigenvalue of a stress is above its mean + ⅔ of its von Mises stress, and none of a smoothed stress is
/// above the largest of those that it is made of: where that is enough nothing else is computed.
void fracture(Deformable& solid, const ElementWorkspace& work, World& world);

inline constexpr int most_cracks = 64;

} // namespace rigor
