// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/meshes/mesh_surface.hpp"
#include "geometry/shapes/pose.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends the contacts of sharp edges of shape 1 with sharp edges of a mesh, where two edges cross
/// at a distance below `reach`.
///
/// The normal of such a contact is perpendicular to both edges. Two edges make a contact only if
/// the angle between them is above 3°, and if the plane perpendicular to the normal separates the
/// faces at one edge from the faces at the other. Overlaps deeper than a twentieth of the longest
/// side of the bounds of the mesh's edges are left to surface points (mesh_contact.hpp).
///
/// @param shape1   a mesh or a box, which have sharp edges; other shapes have no edge contacts
/// @param pose     pose of shape 1 in the frame of the mesh; the contacts are in this frame too
void find_edge_contacts(const Shape& shape1, const Pose& pose, const MeshSurface& surface2,
                        double reach, std::vector<Contact>& contacts);

} // namespace rigor
