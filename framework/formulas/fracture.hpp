// SPDX-License-Identifier: MIT
// Topic `fracture`, assignment A7: where a solid cracks, and what becomes of its mesh.
// Source: lecture "Rigid bodies", "Multi-dimensional fracture"; O'Brien and Hodgins (1999), "Graphical
// modeling and animation of brittle fracture"; Molino, Bao and Fedkiw (2004), "A virtual node algorithm
// for changing mesh topology during simulation". Conventions: types.hpp. Stresses are symmetric, in
// Pa, tension positive. Meshes, points and normals are all in one space, usually that of the solid at
// rest.
//
// Meshes conform: two tetrahedra meet in a whole face, a whole edge, a vertex or nowhere, no more than
// two share a face, and around each vertex they hang together by faces. What is returned does so too.
// Indices are those of something; where one is not, anything finite may be returned.
#pragma once

#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"

namespace rigor {

/// A7.1 The stress of each element, averaged with its neighbours' by volume, against cracks that are
/// nothing but the mesh:
///
///     σ̄ₑ = (Vₑ σₑ + Σ Vₙ σₙ) / (Vₑ + Σ Vₙ)    over the neighbours n of e
///
/// @param stresses    of each element [Pa]
/// @param neighbours  of each element, the indices of others
/// @param volumes     of each element, ≥ 0 [m³]; where all that are averaged are 0: σₑ as it is
std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes);

/// A7.2 The largest eigenvalue of a stress, and a unit eigenvector to it. Where several eigenvalues
/// are equal any unit vector of their space will do.
PrincipalStress principal_stress(const Matrix3d& stress);

/// A7.3 The normal of the crack that a stress opens: the direction of the largest eigenvalue, where
/// that pulls and exceeds the threshold; else empty. What only pushes opens no crack.
std::optional<Vector3d> crack_plane(const Matrix3d& stress, double threshold);

/// A7.4 The face of a tetrahedron whose normal is nearest to a crack's, whichever way either points:
/// the f with the largest |n_f · n|. Of equals the lowest.
///
/// @param tetrahedron  its vertices [m]; a face without area counts as perpendicular to the crack
/// @param normal       n, unit
/// @return  0 … 3: the face opposite that vertex
int closest_face(const std::array<Vector3d, 4>& tetrahedron, const Vector3d& normal);

/// A7.5 The simplest way: the mesh comes apart along faces of its own.
///
/// Around each vertex, tetrahedra that share a face which is not among `faces` stay together, and so do
/// those that a chain of such faces joins, each of which has this vertex. Each group that is left has a
/// vertex of its own. So no tetrahedron changes its shape, a vertex doubles only where the mesh comes
/// apart, and the rim of a crack that ends inside the solid stays closed. A single face inside stays
/// closed altogether, and holds again in the next call: name all faces of a crack at once.
///
/// @param faces  from either side, in any order, also twice; a face of the surface may be named and
///               changes nothing
/// @return  tetrahedra in the order of `mesh`, their corners in their order; vertices in any order
SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces);

/// A7.6 Elements are cut: a crack through a vertex, along a plane (O'Brien and Hodgins 1999).
///
/// The plane through the vertex cuts the tetrahedra that have this vertex. A vertex of theirs that is
/// nearer to the plane than 0.05 of the longest edge among them counts as lying on it. Each of their
/// edges whose ends lie on both sides gets a vertex where it meets the plane, and all tetrahedra that
/// have this edge are halved there, those beyond the vertex's own too, so that the mesh still conforms;
/// one edge after another, in any order. Then each tetrahedron of the vertex is on one side of the
/// plane: that of its vertices which do not lie on it, or of its center if all do. The mesh comes
/// apart, as in `split_along_faces`, along the faces between those on different sides. Volume is kept
/// and no tetrahedron is inverted.
///
/// @param vertex  index into the vertices
/// @param normal  of the plane, unit
/// @return  tetrahedra and vertices in any order; unchanged where no vertex of these tetrahedra is
///          above the plane, or none below
SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal);

/// A7.7 Elements are duplicated, with the crack embedded (Molino, Bao and Fedkiw 2004).
///
/// The cracks of a tetrahedron sort its corners: two are in one part where no crack has them on
/// different sides (a corner on the plane, n·(x - p) ≥ 0, is on the side the normal points to). The
/// tetrahedron is copied once for each part; in its copy the part's corners are real, the others
/// virtual. Two copies of tetrahedra that share a face are joined where a corner of that face is real in
/// both: then all three corners of the face are the same vertices in both. Vertices that nothing joins
/// are separate.
///
/// A copy's share of the volume is that of its part. The cracks of a tetrahedron come one after another,
/// and each divides the matter of the parts whose corners it separates, along its plane; it ends at
/// the others. So the shares of a tetrahedron sum to 1.
///
/// @param cracks  any number for a tetrahedron, in the order in which they came
/// @return  copies in the order of their parents, those of one parent by their first real corner, each
///          with its corners in the parent's order; vertices in any order
EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks);

} // namespace rigor
