// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/types.hpp"

#include <array>

namespace rigor {

/// A convex polygon, a segment or a point of a surface. A circle is eight points of it.
struct Feature {
    static constexpr int most = 16;
    std::array<Vector3d, most> points;
    int count = 0;

    void add(const Vector3d& p)
    {
        if (count < most) points[count++] = p;
    }
};

} // namespace rigor
