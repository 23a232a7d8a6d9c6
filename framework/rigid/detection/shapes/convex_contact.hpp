// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends the contacts of two convex shapes (`is_convex_solid`) that are closer than `reach`.
///
/// All contacts have the same normal: the direction along which the shapes are closest or, if they
/// overlap, along which the shortest move separates them. If both shapes turn a face or a line to
/// each other, one is clipped against the other (Sutherland and Hodgman 1974), and each corner of
/// the result is a contact with its own gap. If no corner is as near as the closest points of the
/// shapes, or if there is no corner, the closest points make a contact too. A mesh that stands for
/// a round body (`SolidMesh::facet_angle` is not 0) may roll to its next facets within a step. So
/// its vertices that are over a flat face of the other shape and closer than `reach` are contacts
/// too. Of all contacts a few are kept (reduce_contacts.hpp).
void find_convex_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                          const Pose& pose2, double reach, std::vector<Contact>& contacts);

} // namespace rigor
