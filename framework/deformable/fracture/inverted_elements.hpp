// SPDX-License-Identifier: MIT
// Elements that stay inverted have failed and are separated from the solid.
#pragma once

#include "deformable/elasticity/element_workspace.hpp"
#include "deformable/solid/handles.hpp"

namespace rigor {

/// Moves the nodes of an element so that its stress is zero: a node at X in the mesh at rest moves
/// to R (δ + ε_p) X, apart from a translation. Here R is the element's rotation, δ the unit matrix
/// and ε_p the plastic strain. The velocities of the nodes become those of a rigid motion with the
/// same momentum and angular momentum. The center of mass stays where it is, and energy is lost. If
/// the element spins so fast that it would gain energy, it is not changed. The element must share
/// no node with another element, which would be deformed otherwise.
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
