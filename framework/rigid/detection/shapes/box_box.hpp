// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends where two boxes are closer than `reach`.
///
/// The axis that separates them most (or that they overlap least along) of the 15 of Gottschalk, Lin
/// and Manocha (1996, "OBBTree: a hierarchical structure for rapid interference detection") decides.
/// A face: the other box's nearest face is clipped against it, and the corners of the polygon, up to 8,
/// are the touches. Two edges: the points where they come closest. A face is preferred to a pair of
/// edges, and of two faces the larger one, unless the other axis is clearly better, and no corner is
/// left out: so that a box at rest keeps its contacts from step to step.
///
/// Where the boxes are apart but would overlap along that axis at the end of the step, and the axis of
/// a face that separates them too would have them overlap less, that one decides: so a box that slides
/// over the joint of two others stays on their tops and does not run into the side of the next.
///
/// @param move  of box 1, against box 2, in the step to come, without forces or contacts [m]
void find_box_contacts(const Box& box1, const Pose& pose1, const Box& box2, const Pose& pose2,
                       const Vector3d& move, double reach, std::vector<Contact>& contacts);

} // namespace rigor
