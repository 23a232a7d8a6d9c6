// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/meshes/mesh_surface.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends where sharp edges of a mesh or a box cross sharp edges of a mesh nearer than `reach`.
///
/// Two edges touch along what is perpendicular to both, if the faces of each lie on its own side of
/// the plane across it. Overlaps that are deep for the shapes are left to their points.
///
/// @param shape1   a mesh or a box has sharp edges; of other shapes nothing is found
/// @param pose     of shape 1 in the frame of the mesh, as are the touches
void find_edge_contacts(const Shape& shape1, const Pose& pose, const MeshSurface& surface2, double reach,
                 std::vector<Contact>& contacts);

} // namespace rigor
