// SPDX-License-Identifier: MIT
// Transfer of the state of a solid to a changed mesh.
//
// Masses are lumped again: each corner of an element gets a quarter of the element's mass. So the
// mass of the solid stays the same. How momenta are conserved depends on the origin of a new node:
//
//   * The copies of a node have its position and velocity, and their masses add up to its mass. So
//     momentum, angular momentum and energy are conserved.
//   * A node p = (1-t) a + t b cuts each element at the edge a b in two. If such an element has
//     mass m, a keeps t m/4 of it, b keeps (1-t) m/4, and p gets m/4. With v_p = (1-t) v_a + t v_b
//     the momentum and the center of mass are conserved, but an angular momentum of
//     t (1-t) m/4 (a - b) × (v_a - v_b) is lost. It is restored by an additional rotation of the
//     nodes of the cut elements about the center of mass of these nodes. This rotation adds no
//     momentum.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// Replaces the mesh of a solid by the result of a split. The state, the handles, the loads and the
/// cracked faces of the solid are transferred.
void remesh(Deformable& solid, const SplitMesh& split);

/// Replaces the mesh of a solid by `embedded`, and transfers the state of the solid. The parent of
/// a new element is the element of the old mesh that contained its material. Handles and loads act
/// on those copies of their nodes that have material.
void remesh(Deformable& solid, EmbeddedMesh embedded);

/// The marked faces as a list, each with the index of its element.
std::vector<MeshFace> marked_faces(const std::vector<std::array<bool, 4>>& crack_faces);

} // namespace rigor
