// SPDX-License-Identifier: MIT
// The functions with a bug that the handouts ask to find, as they stand there. They belong to no
// task. bugs_test.cpp has the law that each of them breaks.
#pragma once

#include "formulas/validation.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <functional>
#include <vector>

namespace rigor::handouts::bugs {

using Eigen::Matrix3d;
using Eigen::Vector3d;

using Root = std::function<double(double)>;

// A1

inline double power(const std::vector<Vector3d>& forces, const std::vector<Vector3d>& velocities)
{
    Vector3d F = Vector3d::Zero(), V = Vector3d::Zero();
    for (std::size_t i = 0; i < forces.size(); ++i) {
        F += forces[i];
        V += velocities[i] / static_cast<double>(forces.size());
    }
    return F.dot(V);
}

// A2

inline double disc_moment(double mass, double radius, int rings)
{
    double J = 0;
    for (int i = 0; i < rings; ++i) {
        const double r = radius * (i + 0.5) / rings;
        J += mass / rings * r * r;
    }
    return J;
}

// A3

inline Matrix3d turned_about_world_axis(const Matrix3d& R, const Vector3d& axis, double angle)
{
    return R * Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

// A4

inline Vector3d after_a_smooth_wall(const Vector3d& v, const Vector3d& n, double restitution)
{
    if (v.dot(n) >= 0) return v;
    return -restitution * v;
}

// A5

inline std::vector<double> couple_wagons(const std::vector<double>& v)
{
    std::vector<double> after = v;
    for (std::size_t i = 0; i + 1 < v.size(); ++i)
        if (v[i] > v[i + 1]) after[i] = after[i + 1] = (v[i] + v[i + 1]) / 2;
    return after;
}

// A6

inline double flowed_rod(double plastic, double strain, double E, double sigma_Y)
{
    const double stress = E * (strain - plastic);
    if (std::abs(stress) <= sigma_Y) return plastic;
    return strain - sigma_Y / E;
}

// A7

inline std::vector<double> smooth_heights(std::vector<double> heights)
{
    for (std::size_t i = 1; i + 1 < heights.size(); ++i)
        heights[i] = (heights[i - 1] + heights[i] + heights[i + 1]) / 3;
    return heights;
}

// A8

inline Judgement test_root(const Root& root)
{
    for (int power = -30; power <= 30; ++power) {
        const double a = std::ldexp(1.0, power), x = root(a);
        if (x < 0 || std::abs(x * x - a) > 1e-12 * a) return rejected();
    }
    return accepted();
}

} // namespace rigor::handouts::bugs
