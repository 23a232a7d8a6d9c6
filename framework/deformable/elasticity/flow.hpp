// SPDX-License-Identifier: MIT
#pragma once

#include "deformable/elasticity/element_workspace.hpp"

namespace rigor {

/// Plastic flow of each element that yields, by `plastic_flow`. The von Mises stress of the others is all
/// that is computed of them. ‖ε_p‖ stays below 0.8, and what is inside out does not flow: so it turns back.
/// @param strains  at the step's end; the elastic ones are updated
void flow(Deformable& solid, ElementWorkspace& work, World& world);

} // namespace rigor
