// SPDX-License-Identifier: MIT
// The order in which contacts and bodies are visited where the result depends on the order. The
// corners of a horizontal face should have the same height, but rounding makes their heights
// differ. Heights that differ only by rounding count as equal here, so the order is the same for
// every correct implementation of the formulas.
#pragma once

#include "formulas/types.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

/// The unit vector opposite to gravity, or y without gravity.
inline Vector3d up_direction(const Vector3d& gravity)
{
    const double g = gravity.norm();
    return g > 0 ? Vector3d(-gravity / g) : Vector3d::UnitY();
}

/// Rounds lengths to 2⁻³⁶ times the power of two below the largest coordinate.
class RoundedLength {
public:
    /// @param points  the points whose lengths will be rounded [m]
    /// @param at      returns the coordinates of one point
    template <typename Points, typename At> RoundedLength(const Points& points, At at)
    {
        double largest = 0;
        for (const auto& p : points)
            largest = std::max(largest, at(p).cwiseAbs().maxCoeff());
        shift_ = std::ldexp(1.5, 16 + (std::isnormal(largest) ? std::ilogb(largest) : 0));
    }

    /// With 2^e the power of two below the largest coordinate, the shift is 1.5 · 2^(e + 16). A sum
    /// of that size has 52 binary digits after the first one, so digits below 2^(e - 36) are
    /// rounded away.
    double operator()(double x) const { return (x + shift_) - shift_; }

private:
    double shift_;
};

/// Makes sort keys of points: by height, lowest first, then by x, then by z.
class HeightOrder {
public:
    struct Key {
        double height, x, z;

        bool operator==(const Key&) const = default;
        bool operator<(const Key& other) const
        {
            if (height != other.height) return height < other.height;
            return x != other.x ? x < other.x : z < other.z;
        }
    };

    template <typename Points, typename At>
    HeightOrder(const Vector3d& gravity, const Points& points, At at)
        : up_(up_direction(gravity)), rounded_(points, at)
    {
    }

    Key operator()(const Vector3d& x) const
    {
        return {rounded_(up_.dot(x)), rounded_(x.x()), rounded_(x.z())};
    }

private:
    Vector3d up_;
    RoundedLength rounded_;
};

} // namespace rigor
