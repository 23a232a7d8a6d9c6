// SPDX-License-Identifier: MIT
// What a solid's stresses do to it after a step.
#pragma once

#include "deformable/workspace.hpp"

namespace rigor {

/// Plastic flow of each element that yields, by `plastic_flow`. The von Mises stress of the others is all
/// that is computed of them. ‖ε_p‖ stays below 0.8, and what is inside out does not flow: so it turns back.
/// @param strains  at the step's end; the elastic ones are updated
void flow(Deformable& solid, Workspace& work, World& world);

/// Cracks where smoothed stresses pull more than the material bears, the most stressed elements first,
/// at most one at a node and `most_cracks` in a step; then the mesh comes apart.
///
/// No eigenvalue of a stress is above its mean + ⅔ of its von Mises stress, and none of a smoothed stress is
/// above the largest of those that it is made of: where that is enough nothing else is computed.
void fracture(Deformable& solid, Workspace& work, World& world);

inline constexpr int most_cracks = 64;

} // namespace rigor
