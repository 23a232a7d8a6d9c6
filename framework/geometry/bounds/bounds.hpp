// SPDX-License-Identifier: MIT
// Axis-aligned bounding boxes.
#pragma once

#include "formulas/types.hpp"

#include <limits>

namespace rigor {

/// An axis-aligned box; as constructed it holds nothing.
struct Bounds {
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity());   // [m]
    Vector3d high = Vector3d::Constant(-std::numeric_limits<double>::infinity()); // [m]

    void include(const Bounds& other)
    {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    void grow(double margin)
    {
        low.array() -= margin;
        high.array() += margin;
    }
    bool contains(const Bounds& other) const
    {
        return (low.array() <= other.low.array()).all() &&
               (other.high.array() <= high.array()).all();
    }
    bool overlaps(const Bounds& other) const
    {
        // without a branch for each axis: which of them keeps boxes apart cannot be predicted
        const auto overlap = [&](int axis) -> int {
            return int{low[axis] <= other.high[axis]} & int{other.low[axis] <= high[axis]};
        };
        return (overlap(0) & overlap(1) & overlap(2)) != 0;
    }
};

/// Squared distance from a point to a box, 0 inside [m²].
inline double squared_distance(const Bounds& box, const Vector3d& p)
{
    return (p - p.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm();
}

} // namespace rigor
