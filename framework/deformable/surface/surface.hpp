// SPDX-License-Identifier: MIT
// The surface of a deformable solid as it is drawn.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// A point of the drawn surface, embedded in an element: x = Σ weights[i] x_i over its corners i.
struct EmbeddedPoint {
    int element = 0;
    Eigen::Vector4d weights = Eigen::Vector4d::Zero(); // barycentric coordinates, with sum 1
};

/// A triangle of the drawn surface, counter-clockwise seen from outside.
struct EmbeddedTriangle {
    std::array<int, 3> points = {0, 0, 0};
    int element = 0;       // the element whose material this triangle bounds
    bool is_crack = false; // whether a crack made it visible
};

/// The surface of a deformable solid. Its points and triangles change only when
/// `Deformable::topology` does.
struct EmbeddedSurface {
    std::vector<EmbeddedPoint> points;
    std::vector<EmbeddedTriangle> triangles;
};

/// The surface to draw, cracks included.
EmbeddedSurface drawn_surface(const Deformable& solid);

} // namespace rigor
