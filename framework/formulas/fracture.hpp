// SPDX-License-Identifier: MIT
// Topic `fracture`, assignment A7: where a solid cracks, and how its mesh changes.
// Source: lecture "Rigid bodies", "Multi-dimensional fracture"; O'Brien and Hodgins (1999),
// "Graphical modeling and animation of brittle fracture"; Molino, Bao and Fedkiw (2004), "A virtual
// node algorithm for changing mesh topology during simulation". Conventions: types.hpp. Stresses
// are symmetric, in Pa, tension positive. Meshes, points and normals are all in one space, usually
// that of the solid at rest.
//
// Apart from earlier cracks, meshes are conforming: two tetrahedra share a whole face, a whole
// edge, a vertex or nothing, at most two tetrahedra share a face, and the tetrahedra around each
// vertex are connected through faces. The returned meshes are conforming too, apart from the two
// sides of a crack, which touch and share nothing but the rim where it ends, and from the copies of
// A7.7: they overlap, and two copies and their neighbor can share one face. A vertex that no
// tetrahedron uses is kept. Every index is valid; for an invalid index the result may be anything
// finite.
#pragma once

#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"

namespace rigor {

/// A7.1 The stress of each element, averaged with the stresses of its neighbors and weighted by
/// volume. The average avoids cracks that are only caused by the mesh.
///
///     σ̄ₑ = (Vₑ σₑ + Σ Vₘ σₘ) / (Vₑ + Σ Vₘ)    over the neighbors m of e
///
/// @param stresses    one for each element [Pa]
/// @param neighbours  for each element, the indices of its neighbors, usually the elements with
///                    which it shares a face; each entry counts, also one that repeats another or
///                    is the element itself
/// @param volumes     one for each element, ≥ 0 [m³]; where all averaged volumes are 0, σₑ is kept
std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes);

/// A7.2 The largest eigenvalue of a stress, and a unit eigenvector for it. If several eigenvalues
/// are equal to it, any unit vector of their eigenspace is correct.
PrincipalStress principal_stress(const Matrix3d& stress);

/// A7.3 The normal of the crack that a stress opens: the direction of the largest eigenvalue, if
/// this eigenvalue is positive (tension) and exceeds the strength; otherwise empty. Compression
/// alone opens no crack.
///
/// @param threshold  the strength of the solid [Pa], which may also be 0 or negative
std::optional<Vector3d> crack_plane(const Matrix3d& stress, double threshold);

/// A7.4 The face of a tetrahedron whose normal is nearest to the normal of a crack: the f with the
/// largest |n_f · n|. The signs of both normals do not matter. If several faces have the largest
/// value, the lowest f; the values are compared without a tolerance.
///
/// @param tetrahedron  its vertices [m], maybe far from the origin, so that only their differences
///                     are small numbers; for a face without area, |n_f · n| counts as 0
/// @param normal       n, unit
/// @return  the index of the face, 0 … 3: that of the opposite vertex
int closest_face(const std::array<Vector3d, 4>& tetrahedron, const Vector3d& normal);

/// A7.5 The simplest method: the mesh splits along faces that it already has.
///
/// Consider the tetrahedra around one vertex. Two of them stay connected if they share a face that
/// has this vertex and is not among `faces`, or if a chain of such faces connects them. Each
/// connected group gets its own vertex. So no tetrahedron changes its shape, a vertex is duplicated
/// only where the mesh splits, and the rim of a crack that ends inside the solid stays closed. If
/// only a single face is given, and none of its edges is on the surface of the solid, it stays
/// closed entirely, and the next call does not remember it. So all faces of a crack must be given
/// at once. Each vertex of the result is an old vertex or a copy of one. In its origin, `first` and
/// `second` are both the index of this old vertex, and `fraction` is 0.
///
/// @param faces  each given from either side, in any order, possibly repeated; a face on the
///               surface of the solid is allowed and changes nothing
/// @return  tetrahedra in the order of `mesh`, with their corners in the same order; vertices in
///          any order
SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces);

/// A7.6 A crack through a vertex, along a plane, that cuts elements (O'Brien and Hodgins 1999).
///
/// The plane through the vertex cuts the tetrahedra that have this vertex, in three steps:
///
/// 1. Heights. The height of a vertex x above the plane is n·(x - x_v), where x_v is the place of
///    the given vertex. A vertex of these tetrahedra counts as lying on the plane if its distance
///    to the plane is less than 0.05 of their longest edge; at 0.05, up to rounding, either is
///    right.
/// 2. Cut edges. Each of their edges with ends on different sides gets a new vertex where it
///    crosses the plane. All tetrahedra of the mesh that have this edge are halved there, also
///    those without the vertex, so that the mesh stays conforming. The edges are processed one
///    after another, in any order.
/// 3. Split. Now each tetrahedron of the vertex is on one side of the plane: on the side of its
///    vertices that do not count as lying on it. If all four count as lying on it, the mean of
///    their heights decides, without a tolerance (above, if it is exactly 0). The mesh splits, as
///    in `split_along_faces`, along the faces between tetrahedra on different sides.
///
/// The volume is conserved and no tetrahedron is inverted. Origins and parents refer to `mesh`.
///
/// @param vertex  index into the vertices
/// @param normal  unit normal of the plane
/// @return  tetrahedra and vertices in any order; unchanged if no vertex of these tetrahedra is
///          above the plane, or none is below, or if no tetrahedron has the vertex. A vertex that
///          counts as lying on the plane is neither above nor below it.
SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal);

/// A7.7 Cracked elements are duplicated and the crack is embedded in them (Molino, Bao and Fedkiw
/// 2004).
///
/// The cracks of a tetrahedron divide its corners into parts: two corners are in the same part if
/// no crack has them on different sides. A crack is the plane through its `point` with the normal
/// n. A corner x with n·(x - point) ≥ 0, also one on the plane, is on the side that n points to.
/// The tetrahedron is copied once for each part. In each copy the corners of its part are real and
/// the others are virtual. Two copies of tetrahedra that share a face are joined if a corner of
/// that face is real in both: then all three corners of the face are the same vertices in both.
/// Vertices that are not joined are separate.
///
/// Each copy has the share of the volume that its part has. The cracks of a tetrahedron are applied
/// in order. Each crack cuts, along its plane, the material of those parts that have corners on
/// both its sides. A part with all corners on one side stays whole: the crack ends there. The
/// planes stay where they are: unlike in A7.6, no corner that is near a plane counts as lying on
/// it. So the shares of a tetrahedron sum to 1. With a single crack, the heights n·(x - point) of
/// the corners alone determine the shares, so a tetrahedron without volume has shares too.
///
/// @param cracks  any number of cracks for each tetrahedron, in the order in which they opened
/// @return  copies in the order of their parents, those of one parent ordered by their first real
///          corner, each with its corners in the parent's order; vertices in any order
EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks);

} // namespace rigor
