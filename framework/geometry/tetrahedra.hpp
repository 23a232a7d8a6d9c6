// SPDX-License-Identifier: MIT
// Meshes of tetrahedra: what one must be to be a solid, its faces, its generators.
#pragma once

#include "formulas/types.hpp"
#include "geometry/obj.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace rigor {

inline constexpr std::size_t most_tetrahedra = 1'000'000, most_tetrahedron_vertices = 1'000'000;

/// The vertices of face f of a tetrahedron, the one opposite vertex f, counter-clockwise seen from
/// outside.
inline constexpr std::array<std::array<int, 3>, 4> tetrahedron_faces = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Signed volume, positive if (b - a, c - a, d - a) are right-handed [m³].
inline double tetrahedron_volume(const Vector3d& a, const Vector3d& b, const Vector3d& c,
                                 const Vector3d& d)
{
    return (b - a).dot((c - a).cross(d - a)) / 6;
}
double tetrahedron_volume(const TetrahedralMesh& mesh, int tetrahedron);

/// Of each tetrahedron and each of its faces, the tetrahedron on the other side; -1: none.
std::vector<std::array<int, 4>> face_neighbours(const TetrahedralMesh& mesh);

/// The faces with one tetrahedron, counter-clockwise seen from outside, on the mesh's own vertices.
TriangleMesh boundary(const TetrahedralMesh& mesh);

/// Refuses what is not one solid: no tetrahedron at all, too many, a vertex that is not a number, does
/// not exist or belongs to none, a tetrahedron that is flat (its volume under 1e-9 of its longest
/// edge's cube) or inverted, a face that three share or two from the same side, a solid in several
/// pieces. Pieces that meet in an edge or a vertex only do not hang together: nothing would hold them.
///
/// @param lines  of each tetrahedron in its text, to name in the error; empty: none
/// @throws MeshError
void check_mesh(const TetrahedralMesh& mesh, const std::vector<int>& lines = {});

// Generators. A block is divided into cells, and each cell into five tetrahedra: one in the middle, with
// a third of the volume, and four corners. Neighbouring cells are mirror images of each other, so the
// mesh conforms; with an even number of cells along an axis it is its own mirror image along that axis.

/// A block about the origin: bar, beam, plate. @param cells  along x, y, z; at least 1 each
TetrahedralMesh block_tetrahedra(const Vector3d& size, const std::array<int, 3>& cells);

/// A block with a notch that comes down in the middle of its upper side and goes through along z.
/// @param notch  cells that are missing along x and down along y, each less than there are
TetrahedralMesh notched_tetrahedra(const Vector3d& size, const std::array<int, 3>& cells,
                                   const std::array<int, 2>& notch);

/// A ball about the origin: an octahedron of 8 layers³ tetrahedra, blown up. It is its own mirror image
/// in x, y and z.
TetrahedralMesh ball_tetrahedra(double radius, int layers);

} // namespace rigor
