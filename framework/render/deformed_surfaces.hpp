// SPDX-License-Identifier: MIT
// The surfaces of deforming solids as triangles to draw.
#pragma once

#include "deformable/surface/surface.hpp"
#include "render/picture.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <functional>

namespace rigor {

/// The triangles of a solid's surface as it is now: smooth where it bends by less than 30 degrees,
/// with edges where it bends by more and around what a crack opened.
///
/// @param color  of a corner of a triangle: of the triangle, and the point of the surface
void add_deformed_surface(std::vector<DeformedVertex>& vertices, const SolidFrame& solid,
                          const std::function<Vector4f(const EmbeddedTriangle&, int point)>& color);

/// A quantity of elements at the points of the surface: the mean of the elements around each node,
/// between the nodes evenly.
std::vector<float> at_points(const SolidTopology& topology, const std::vector<float>& of_elements);

} // namespace rigor
