// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/types.hpp"

#include <array>

namespace rigor {

/// A feature of a convex surface: a polygon, a segment or a point. A circle is given as eight
/// points.
struct Feature {
    /// The largest number of points. More would represent large faces better, but take more time.
    static constexpr int most = 16;
    std::array<Vector3d, most> points;
    int count = 0;

    void add(const Vector3d& p)
    {
        if (count < most) points[count++] = p;
    }
};

} // namespace rigor
