// SPDX-License-Identifier: MIT
// Comparison of mass properties, each field at its own scale, and their sum over particles, which
// uses no formula of the assignments.
#pragma once

#include "support/close.hpp"

#include <cmath>

namespace rigor::testing {

/// Compares up to k eps: the mass at its own scale, the center of mass at the scale of `extent`,
/// and the inertia at the scale of mass × extent².
///
/// @param extent  the largest distance of matter from the origin [m]
inline void require_mass_properties(const MassProperties& actual, const MassProperties& expected,
                                    double extent, double k)
{
    const double M = std::abs(expected.mass);
    {
        INFO("mass [kg]");
        REQUIRE_THAT(actual.mass, IsClose(expected.mass, Rounding(k, M)));
    }
    {
        INFO("center of mass [m]");
        REQUIRE_THAT(actual.center_of_mass, IsClose(expected.center_of_mass, Rounding(k, extent)));
    }
    INFO("inertia about the center of mass [kg m²]");
    REQUIRE_THAT(actual.inertia, IsClose(expected.inertia, Rounding(k, M * extent * extent)));
}

/// Mass properties of particles whose total mass is not 0.
inline MassProperties sum_of(const std::vector<Particle>& particles)
{
    MassProperties sum;
    for (const auto& [m, p] : particles) {
        sum.mass += m;
        sum.center_of_mass += m * p;
    }
    sum.center_of_mass /= sum.mass;
    for (const auto& [m, p] : particles) {
        const Vector3d d = p - sum.center_of_mass;
        sum.inertia += m * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    return sum;
}

} // namespace rigor::testing
