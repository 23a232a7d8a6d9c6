// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/bodies/counters.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends where a mesh and another solid shape are nearer than `reach`, at most eight touches.
///
/// Points of each surface are looked up in the distance of the other: of a mesh in its level set, of
/// any other shape in the exact one (Guendelman, Bridson and Fedkiw 2003, "Nonconvex rigid bodies with
/// stacking"). The normal is the gradient there, or what of the point's own normals is nearest to it:
/// so that a corner on an edge pushes along the face. Edges are held against edges exactly: bars that
/// cross touch where no point of either lies in the other.
///
/// @param shape1  a mesh, a box, a cylinder, a cone or an ellipsoid
/// @param shape2  a mesh
void find_mesh_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                        const Pose& pose2, double reach, Counters& counters,
                        std::vector<Contact>& contacts);

/// Appends where points of a mesh are nearer than `reach` to a shape that is none, not reduced.
void find_point_contacts(const Shape& shape1, const Pose& pose1, const SolidMesh& mesh2,
                         const Pose& pose2, double reach, Counters& counters,
                         std::vector<Contact>& contacts);

} // namespace rigor
