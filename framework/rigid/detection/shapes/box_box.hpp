// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends the contacts of two boxes that are closer than `reach`.
///
/// The separating axis test with the 15 axes of Gottschalk, Lin and Manocha (1996, "OBBTree: a
/// hierarchical structure for rapid interference detection") finds the axis along which the boxes
/// are farthest apart or overlap least. If it is the normal of a face, the nearest face of the
/// other box is clipped against this face, and the up to 8 corners of the polygon are the contacts.
/// If it belongs to two edges, their closest points make the contact. A face is preferred to a
/// pair of edges, and the larger of two faces to the smaller one, unless the other axis is clearly
/// better. No corner closer than `reach` is left out. So a box at rest keeps its contacts from step
/// to step.
///
/// The boxes may be apart now but overlap along that axis at the end of the step. If another face
/// separates them now and they would overlap less along its normal, that face is used instead. So a
/// box that slides over the joint between two others stays on top of them and does not run into the
/// side of the second one. If the boxes do not face each other now but will overlap, as boxes that
/// meet edge to edge, the face is extended by the displacement of the other box.
///
/// @param move  displacement of box 1 relative to box 2 in this step, without forces or contacts
///              [m]
void find_box_contacts(const Box& box1, const Pose& pose1, const Box& box2, const Pose& pose2,
                       const Vector3d& move, double reach, std::vector<Contact>& contacts);

} // namespace rigor
