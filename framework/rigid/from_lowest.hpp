// SPDX-License-Identifier: MIT
// The order in which contacts and bodies are gone through, where an order there must be. Points of one face
// lie at one height although they were rotated there: what only roundings tell apart counts as equal, so
// that whoever computes a formula otherwise goes through them in the same order.
#pragma once

#include "rigid/forces.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

/// Rounds lengths to 2⁻³⁶ of the power of two below the largest coordinate.
class Coarse {
public:
    /// @param points  what the lengths were computed from [m]
    /// @param at      the point of one of them
    template <typename Points, typename At> Coarse(const Points& points, At at)
    {
        double largest = 0;
        for (const auto& p : points)
            largest = std::max(largest, at(p).cwiseAbs().maxCoeff());
        shift_ = std::ldexp(1.5, 16 + (std::isnormal(largest) ? std::ilogb(largest) : 0));
    }

    /// What is added leaves no digits below the 36th: 16 + 36 are all that a double has.
    double operator()(double x) const { return (x + shift_) - shift_; }

private:
    double shift_;
};

/// Places that compare from the lowest up, and at one height by x, then z.
class FromLowest {
public:
    struct Place {
        double height, x, z;

        bool operator==(const Place&) const = default;
        bool operator<(const Place& other) const
        {
            if (height != other.height) return height < other.height;
            return x != other.x ? x < other.x : z < other.z;
        }
    };

    template <typename Points, typename At>
    FromLowest(const Vector3d& gravity, const Points& points, At at)
        : up_(up_against(gravity)), coarse_(points, at)
    {
    }

    Place operator()(const Vector3d& x) const
    {
        return {coarse_(up_.dot(x)), coarse_(x.x()), coarse_(x.z())};
    }

private:
    Vector3d up_;
    Coarse coarse_;
};

} // namespace rigor
