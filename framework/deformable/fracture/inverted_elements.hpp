// SPDX-License-Identifier: MIT
// Elements that stay inverted have failed and are separated from the solid.
#pragma once

#include "deformable/elasticity/element_workspace.hpp"
#include "deformable/solid/handles.hpp"

namespace rigor {

/// Moves the nodes of an element to its shape without stress, R (δ + ε_p) X, and gives them the
/// motion of a rigid body. Here R is the element's rotation, δ the unit matrix, ε_p the plastic
/// strain, and X a position in the mesh at rest. The element must share no node with another
/// element, which would be deformed otherwise. Mass, center of mass, momentum and angular momentum
/// stay the same; energy is lost. If the element spins so fast that it would gain energy, it is not
/// changed.
/// @return whether the element was changed
bool relax_element(Deformable& solid, int element);

/// Finds the elements that have been inverted for too long, and separates them from the solid along
/// all their faces. Those that then share no node with another element are relaxed by
/// `relax_element`.
///
/// The elastic force on an inverted element is bounded, so neighbors at the limit of their plastic
/// strain can hold it inverted forever. The time does not count for elements with a node that a
/// handle holds.
/// @return  whether an element was inverted for too long; strains computed before are then out of
///          date
bool separate_inverted_elements(Deformable& solid, const ElementWorkspace& work,
                                const std::vector<HeldNode>& held, World& world, double time_step);

} // namespace rigor
