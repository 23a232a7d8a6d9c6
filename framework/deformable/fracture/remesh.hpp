// SPDX-License-Identifier: MIT
// A solid on a changed mesh.
//
// Masses are lumped anew: a quarter of each element's matter at each of its corners. Matter is neither
// made nor lost, so mass closes. Momenta follow from where new nodes come from:
//
//   * Copies of a node have its place and velocity, and their masses add up to its mass. Both momenta and
//     the energy are kept.
//   * A node p = (1-t) a + t b halves the elements at the edge a b. Of an element's mass m, t m/4 stays at a,
//     (1-t) m/4 at b, and m/4 goes to p. With v_p = (1-t) v_a + t v_b the momentum is kept, and the center of
//     mass; but t (1-t) m/4 (a - b) × (v_a - v_b) of angular momentum is lost, as the stretch of the edge's
//     spin that the node in its middle cannot have. It is given back as a spin of the nodes around the
//     cut, about their own center of mass, which has no momentum.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// Puts a solid on a mesh that came from splitting its own: state, handles, loads and the faces that are
/// cracks go with it.
void remesh(Deformable& solid, const SplitMesh& split);

/// The same with virtual nodes. Of each copy the old copy whose matter it holds is its parent. A handle
/// holds of a node's copies those with matter.
void remesh(Deformable& solid, EmbeddedMesh embedded);

/// The faces where a crack runs.
std::vector<MeshFace> marked_faces(const std::vector<std::array<bool, 4>>& crack_faces);

} // namespace rigor
