// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/bodies/counters.hpp"
#include "rigid/detection/contact.hpp"

#include <vector>

namespace rigor {

/// Whether each of two bodies is still, and the displacement of body 1 relative to body 2 that
/// their velocities give in this step.
struct MovingPair {
    bool is_still1 = false, is_still2 = false;
    Vector3d move = Vector3d::Zero();

    /// The share of `move` by which a contact point moves relative to body 2. If only one body
    /// moves, the point moves with this body. If both move, the share is one half.
    double point_share() const { return is_still2 ? 1 : is_still1 ? 0 : 0.5; }
};

/// Changes the contacts that were found for two shapes at the start of the step, if the shapes will
/// have others after their move. All gaps are those at the start of the step.
///
/// 1. One of the shapes is concave: contacts are added with the part that the other shape reaches,
///    as in a bowl, where the wall ahead is steeper than the wall below. Without them, a shape
///    would move into the wall, and the position correction would lift the shape, which adds
///    energy. This is done only where it is worth its time: if the body of the concave shape is
///    still, or the other shape has a core (`has_core`).
/// 2. One of the shapes has flat sides (a box or a convex mesh): the contacts with its edges and
///    corners are replaced if there is a normal along which the shapes do not overlap now and will
///    overlap less. So a shape that slides over the joint between two boxes stays on top of them,
///    and does not run into the edge that belongs to the second box. (Two boxes, and a sphere and a
///    box, have methods that look ahead.)
///
/// @param reach     contacts are closer than this [m]
/// @param first     the contacts of these two shapes start at this index
/// @param counters  receives the counts of built level sets and of their samples
void look_ahead(const Shape& shape1, const Pose& pose1, const Shape& shape2, const Pose& pose2,
                const MovingPair& pair, double reach, Counters& counters, std::size_t first,
                std::vector<Contact>& contacts);

} // namespace rigor
