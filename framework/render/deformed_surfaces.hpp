// SPDX-License-Identifier: MIT
// The surfaces of deforming solids as triangles to draw.
#pragma once

#include "deformable/surface/surface.hpp"
#include "render/picture.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <functional>

namespace rigor {

/// Appends the triangles of a solid's surface in this frame. The surface is smooth where it bends
/// by less than 30 degrees, with edges where it bends by more and around surfaces that a crack
/// opened.
///
/// @param color  a function that returns the color of a corner, from the corner's triangle and the
///               index of its point
void add_deformed_surface(std::vector<DeformedVertex>& vertices, const SolidFrame& solid,
                          const std::function<Vector4f(const EmbeddedTriangle&, int point)>& color);

/// The values of a quantity at the points of the surface, from its values in the elements. Each
/// node gets the mean of the elements around it, and the points get values interpolated linearly
/// between the nodes.
std::vector<float> at_points(const SolidTopology& topology, const std::vector<float>& of_elements);

} // namespace rigor
