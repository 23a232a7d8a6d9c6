// SPDX-License-Identifier: MIT
// Surfaces of shapes as triangles to draw.
#pragma once

#include "geometry/shapes/shape.hpp"
#include "render/picture.hpp"

namespace rigor {

/// The surface of a shape that is not a box, ball, ellipsoid or plane: smooth where it bends by
/// less than 30 degrees, with edges where it bends by more.
Surface surface_of(const Shape& shape);

} // namespace rigor
