// SPDX-License-Identifier: MIT
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// A point of the drawn surface, which moves with an element: Σ weights[i] x_corner i.
struct EmbeddedPoint {
    int element = 0;
    Eigen::Vector4d weights = Eigen::Vector4d::Zero(); // barycentric, sum 1
};

/// A triangle of the drawn surface, counter-clockwise seen from outside.
struct EmbeddedTriangle {
    std::array<int, 3> points = {0, 0, 0};
    int element = 0;       // that it belongs to
    bool is_crack = false; // opened by a crack
};

/// The surface of a deformable as its mesh is now; it changes only with `topology`.
struct EmbeddedSurface {
    std::vector<EmbeddedPoint> points;
    std::vector<EmbeddedTriangle> triangles;
};

/// The surface to draw, cracks included.
EmbeddedSurface drawn_surface(const Deformable& solid);

} // namespace rigor
