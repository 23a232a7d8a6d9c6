// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/meshes/mesh_surface.hpp"
#include "geometry/shapes/pose.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends the contacts where sharp edges of a mesh or a box cross sharp edges of a mesh that are
/// closer than `reach`.
///
/// The normal of such a contact is perpendicular to both edges. It is a contact only if the
/// faces of each edge lie on their own side of the plane across the normal. Overlaps that are deep
/// relative to the size of the mesh are left to the surface points.
///
/// @param shape1   a mesh or a box, which have sharp edges; other shapes have no edge contacts
/// @param pose     pose of shape 1 in the frame of the mesh; the contacts are in this frame too
void find_edge_contacts(const Shape& shape1, const Pose& pose, const MeshSurface& surface2,
                        double reach, std::vector<Contact>& contacts);

} // namespace rigor
