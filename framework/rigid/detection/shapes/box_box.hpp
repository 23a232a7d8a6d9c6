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
/// are farthest apart or overlap least. If this axis is the normal of a face, the nearest face of
/// the other box is clipped against this face, and the corners of the resulting polygon, at most 8,
/// are the contacts. If the axis belongs to two edges, the closest points of the edges make the
/// contact. A face is preferred to a pair of edges, and the larger of two faces to the smaller one,
/// unless the other axis is clearly better. Every corner closer than `reach` is kept. So a box at
/// rest keeps its contacts from step to step.
///
/// The boxes may be apart along this axis now but overlap along it at the end of the step. If
/// another face separates them now and they would overlap less along its normal, this other face is
/// used instead. So a box that slides over the joint between two others stays on top of them and
/// does not run into the side of the second one. Boxes that will meet edge to edge may not face
/// each other now, although they overlap at the end of the step. Then the face is extended by the
/// displacement of the other box.
///
/// @param move  displacement of box 1 relative to box 2 in this step, without forces or contacts
///              [m]
void find_box_contacts(const Box& box1, const Pose& pose1, const Box& box2, const Pose& pose2,
                       const Vector3d& move, double reach, std::vector<Contact>& contacts);

} // namespace rigor
