// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/bodies/counters.hpp"
#include "rigid/detection/contact.hpp"

#include <span>

namespace rigor {

/// Appends the contacts of a mesh and another solid shape that are closer than `reach`, at most
/// eight.
///
/// The surface points of each shape are tested in the signed distance of the other shape
/// (Guendelman, Bridson and Fedkiw 2003, "Nonconvex rigid bodies with stacking"): a mesh has its
/// level set, any other shape its exact distance. The contact normal is opposite to one of the
/// outward normals of the point's own surface: the one that is nearest to the negative gradient of
/// the distance. So a point in the middle of a face pushes along the normal of this face, even at
/// an edge of the other shape. Points ahead of a rolling wheel are left out. Edges are tested
/// against edges exactly, so that crossing bars touch although no point of one bar lies inside the
/// other. If tested points are inside the other shape but no contact has a negative gap, the
/// deepest of these points becomes a contact along the gradient of the distance.
///
/// @param shape1  a mesh, a box, a cylinder, a cone or an ellipsoid
/// @param shape2  a mesh
void find_mesh_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                        const Pose& pose2, double reach, Counters& counters,
                        std::vector<Contact>& contacts);

/// Appends the contacts of a mesh's surface points that are closer than `reach` to a shape that is
/// not a mesh. Several points close together make one contact. `reduce_contacts` is not called.
void find_point_contacts(const Shape& shape1, const Pose& pose1, const SolidMesh& mesh2,
                         const Pose& pose2, double reach, Counters& counters,
                         std::vector<Contact>& contacts);

/// Removes the contacts at points of flat faces of a mesh for which all of these conditions hold:
///   1. The contact has a gap.
///   2. Its point is not the point of the face that is nearest to shape 1.
///   3. Another contact with the same face has a smaller gap.
/// Such points lie ahead of a rolling wheel, which passes over them without touching them. Contacts
/// at these points could stop the wheel.
///
/// @param points  contacts of a mesh's surface points with shape 1, which is no mesh
/// @param others  contacts of points of shape 1 with the mesh
/// @param share   distance of the points of `others` from the mesh, divided by the gap: 1/2 or 1
void remove_points_ahead(std::vector<Contact>& points, const Shape& shape1, const Pose& pose1,
                         std::span<const Contact> others, double share);

} // namespace rigor
