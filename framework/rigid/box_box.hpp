// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/narrow_phase.hpp"

namespace rigor {

/// Appends where two boxes are closer than `reach`.
///
/// The axis that separates them most (or that they overlap least along) of the 15 of Gottschalk, Lin
/// and Manocha (1996, "OBBTree: a hierarchical structure for rapid interference detection") decides.
/// A face: the other box's nearest face is clipped against it, and the corners of the polygon, up to 8,
/// are the touches. Two edges: the points where they come closest. A face is preferred to a pair of
/// edges, and of two faces the larger one, unless the other axis is clearly better, and no corner is
/// left out: so that a box at rest keeps its contacts from step to step.
void touch_boxes(const Box& box1, const Pose& pose1, const Box& box2, const Pose& pose2,
                 double reach, std::vector<Touch>& touches);

} // namespace rigor
