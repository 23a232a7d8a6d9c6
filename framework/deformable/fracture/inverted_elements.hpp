// SPDX-License-Identifier: MIT
// What is crushed inside out and stays so has failed, and comes off.
#pragma once

#include "deformable/elasticity/element_workspace.hpp"
#include "deformable/solid/handles.hpp"

namespace rigor {

/// Gives an element whose nodes are no other's the shape that it has without stress, R (δ + ε_p) X, and the
/// motion of a rigid body about its center of mass. Mass, center of mass, momentum and angular momentum
/// stay; energy is lost. If it spins so fast that it would gain some it is left as it is.
/// @return whether it was changed
bool relax_element(Deformable& solid, int element);

/// Elements that are inside out for too long come off along all their faces and are unloaded.
///
/// Linear elasticity pulls at an inverted element with a bounded force only, and neighbours that have
/// flowed as far as they may can hold it so for ever. Elements with a node that a handle holds wait.
/// @return whether there were any: then strains of before no longer count
bool separate_inverted_elements(Deformable& solid, const ElementWorkspace& work,
                                const std::vector<HeldNode>& held, World& world, double time_step);

} // namespace rigor
