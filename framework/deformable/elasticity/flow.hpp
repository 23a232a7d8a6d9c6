// SPDX-License-Identifier: MIT
// Plastic flow of the elements of a solid.
#pragma once

#include "deformable/elasticity/element_workspace.hpp"

namespace rigor {

/// Plastic flow of each element that yields, by `plastic_flow`. For all others only the von Mises
/// stress is computed. ‖ε_p‖ stays at most 0.8, and an inverted element does not flow, so that its
/// elastic stress can turn it back.
///
/// @param work  with the strains at the end of the step; flow updates their elastic parts
void flow(Deformable& solid, ElementWorkspace& work, World& world);

} // namespace rigor
