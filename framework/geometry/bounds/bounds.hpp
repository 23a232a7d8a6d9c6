// SPDX-License-Identifier: MIT
// Axis-aligned bounding boxes.
#pragma once

#include "formulas/types.hpp"

#include <limits>

namespace rigor {

/// An axis-aligned box. A default-constructed box is empty, and overlaps no box with finite
/// corners.
struct Bounds {
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity());   // [m]
    Vector3d high = Vector3d::Constant(-std::numeric_limits<double>::infinity()); // [m]

    /// Grows to the smallest box that contains both this box and `other`.
    void include(const Bounds& other)
    {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    /// Moves every side outwards by a margin [m].
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
    /// Whether the boxes have a point in common; boxes that only touch have one.
    bool overlaps(const Bounds& other) const
    {
        // `&` avoids a branch for each axis: a processor cannot predict which axis separates boxes.
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
