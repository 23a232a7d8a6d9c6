// SPDX-License-Identifier: MIT
// The order in which contacts and bodies are visited where the result depends on the order. The
// corners of a horizontal face should have the same height, but rounding makes their heights
// differ. Heights that differ only by rounding count as equal here, so the order is the same for
// every correct implementation of the formulas.
#pragma once

#include "formulas/types.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

/// The unit vector opposite to gravity, or the y axis if there is no gravity.
inline Vector3d up_direction(const Vector3d& gravity)
{
    const double g = gravity.norm();
    return g > 0 ? Vector3d(-gravity / g) : Vector3d::UnitY();
}

/// Rounds lengths to multiples of a unit that follows from the extent of a set of points and not
/// from their distance to the origin. So a set of points is rounded in the same way wherever it is,
/// unless its distance to the origin is more than about a thousand times its extent.
class RoundedLength {
public:
    /// @param points  the points whose coordinates and heights will be rounded
    /// @param at      a function that returns the position of an element of `points` [m]
    template <typename Points, typename At> RoundedLength(const Points& points, At at)
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        Vector3d most = Vector3d::Constant(-infinity);
        least_.setConstant(infinity);
        for (const auto& p : points) {
            least_ = least_.cwiseMin(at(p));
            most = most.cwiseMax(at(p));
        }
        const double extent = (most - least_).maxCoeff();
        const double farthest = least_.cwiseAbs().cwiseMax(most.cwiseAbs()).maxCoeff();
        shift_ = std::ldexp(1.5, std::max(16 + exponent_of(extent), 6 + exponent_of(farthest)));
    }

    /// Rounds x to a multiple of 2^(e - 36), where 2^e is the largest power of two up to the extent
    /// (the longest side of the points' bounding box). The sum of x and the shift 1.5 · 2^(e + 16)
    /// is such a multiple, because a double of this size has no smaller digits; then the shift is
    /// subtracted again. Far from the origin, coordinates are less exact than 2^(e - 36). So the
    /// unit is at least 2^(f - 46), where 2^f is the largest power of two up to the largest
    /// absolute coordinate. This unit is 64 times the spacing of doubles that are as large as this
    /// coordinate.
    double operator()(double x) const { return (x + shift_) - shift_; }

    /// The position of x relative to the corner of the points' bounding box where all coordinates
    /// are least.
    Vector3d from_least(const Vector3d& x) const { return x - least_; }

private:
    static int exponent_of(double x)
    {
        constexpr int none = -1000; // exponent for 0 and infinity; any length has a larger one
        return std::isnormal(x) ? std::ilogb(x) : none;
    }

    Vector3d least_;
    double shift_;
};

/// Makes sort keys of points. Points are sorted by height, lowest first, then by x, z and y. These
/// numbers are rounded by `RoundedLength`.
class HeightOrder {
public:
    struct Key {
        double height, x, z, y;

        bool operator==(const Key&) const = default;
        bool operator<(const Key& other) const
        {
            if (height != other.height) return height < other.height;
            if (x != other.x) return x < other.x;
            return z != other.z ? z < other.z : y < other.y;
        }
    };

    template <typename Points, typename At>
    HeightOrder(const Vector3d& gravity, const Points& points, At at)
        : up_(up_direction(gravity)), rounded_(points, at)
    {
    }

    Key operator()(const Vector3d& x) const
    {
        const Vector3d r = rounded_.from_least(x);
        return {rounded_(up_.dot(r)), rounded_(r.x()), rounded_(r.z()), rounded_(r.y())};
    }

private:
    Vector3d up_;
    RoundedLength rounded_;
};

} // namespace rigor
