// SPDX-License-Identifier: MIT
#include "candidates.hpp"

#include <cmath>

namespace rigor::testing {

namespace {

// The cross product with the axis that is farthest from n.
Vector3d by_the_farthest_axis(Vector3d n)
{
    int least = 0;
    n.cwiseAbs().minCoeff(&least);
    return n.cross(Vector3d::Unit(least)).normalized();
}

// Hughes and Möller 1999, "Building an orthonormal basis from a unit vector".
Vector3d by_a_swap(Vector3d n)
{
    const Vector3d t =
        std::abs(n.x()) > std::abs(n.z()) ? Vector3d(-n.y(), n.x(), 0) : Vector3d(0, -n.z(), n.y());
    return t / t.norm();
}

// Duff et al. 2017, "Building an orthonormal basis, revisited".
Vector3d without_a_root(Vector3d n)
{
    const double sign = std::copysign(1.0, n.z());
    const double a = -1 / (sign + n.z());
    return {1 + sign * n.x() * n.x() * a, sign * n.x() * n.y() * a, -sign * n.x()};
}

// The part of an axis that is perpendicular to n, with either sign.
Vector3d by_projection(Vector3d n)
{
    const Vector3d axis = std::abs(n.y()) < 0.7 ? Vector3d::UnitY() : Vector3d::UnitX();
    Vector3d t = axis - axis.dot(n) * n;
    t.normalize();
    t -= t.dot(n) * n;
    return -t.normalized();
}

const Candidates<Tangent>::Wrong ordinary_tangents = {
    {"is not a unit vector", [](Vector3d n) { return Vector3d(2 * without_a_root(n)); }},
    {"is not a unit vector unless n is perpendicular to an axis",
     [](const Vector3d& n) {
         const Vector3d t(-n.y(), n.x(), 0);
         return Vector3d(t + (t.isZero(0) ? Vector3d::UnitX() : Vector3d(Vector3d::Zero())));
     }},
    {"is not perpendicular to n", [](Vector3d n) { return n; }},
    {"is not perpendicular to n unless n is along an axis",
     [](const Vector3d& n) {
         int least = 0;
         n.cwiseAbs().minCoeff(&least);
         return Vector3d(Vector3d::Unit(least));
     }},
    {"is not perpendicular to n, but nearly",
     [](const Vector3d& n) { return Vector3d((by_a_swap(n) + 0.001 * n).normalized()); }},
    {"is zero", [](const Vector3d&) { return Vector3d(Vector3d::Zero()); }},
};

const Candidates<Tangent>::Wrong special_tangents = {
    {"is wrong for one of the axes",
     [](const Vector3d& n) { return Vector3d(n.cross(Vector3d::UnitX()).normalized()); }},
    {"is wrong for one of the axes",
     [](const Vector3d& n) { return Vector3d(n.cross(Vector3d::UnitY()).normalized()); }},
    {"is wrong for one of the axes",
     [](const Vector3d& n) {
         const Vector3d t(-n.y(), n.x(), 0);
         return Vector3d(t / t.norm());
     }},
    {"is wrong for one of the six directions of the axes",
     [](const Vector3d& n) {
         const double a = 1 / (1 + n.z()); // divides by zero
         return Vector3d(1 - n.x() * n.x() * a, -n.x() * n.y() * a, -n.x());
     }},
    {"is wrong on one side of a plane of two axes",
     [](const Vector3d& n) { return Vector3d((n.y() < 0 ? 0.5 : 1) * by_a_swap(n)); }},
    {"is wrong near an axis, but not on it",
     [](const Vector3d& n) {
         if (std::abs(n.x()) > 0.99) return Vector3d(Vector3d::UnitY());
         return by_the_farthest_axis(n);
     }},
    {"is wrong very near an axis, but not on it",
     [](const Vector3d& n) {
         if (std::hypot(n.y(), n.z()) < 1e-7) return Vector3d(Vector3d::UnitY());
         return by_the_farthest_axis(n);
     }},
    {"is wrong very near a diagonal between two axes, but not on it",
     [](const Vector3d& n) {
         if (std::hypot(n.x() - n.y(), n.z()) < 1e-8) return Vector3d(1, -1, 0).normalized();
         return by_a_swap(n);
     }},
    {"is wrong nearer than 1e-9 to an axis, but not on it",
     [](const Vector3d& n) {
         if (std::hypot(n.x(), n.y()) < 1e-9) return Vector3d(Vector3d::UnitX());
         return by_the_farthest_axis(n);
     }},
    {"is wrong nearer than 1e-9 to a diagonal of all axes, but not on it",
     [](const Vector3d& n) {
         const Vector3d a = n.cwiseAbs(), t(n.y(), -n.x(), 0);
         if (a.maxCoeff() - a.minCoeff() < 1e-9) return Vector3d(t.cwiseSign().normalized());
         return by_a_swap(n);
     }},
    {"is wrong near an axis and not in a plane of two axes",
     [](const Vector3d& n) {
         const bool is_near = std::hypot(n.x(), n.z()) < 1e-5;
         return is_near && n.x() != 0 && n.z() != 0 ? Vector3d(Vector3d::UnitX())
                                                    : by_the_farthest_axis(n);
     }},
    {"is wrong where a component is nearly 0",
     [](Vector3d n) {
         for (double& component : n)
             if (std::abs(component) < 1e-7) component = 0;
         return without_a_root(n);
     }},
    {"is off by a ten-millionth",
     [](const Vector3d& n) { return Vector3d((1 + 1e-7) * by_projection(n)); }},
};

} // namespace

const Candidates<Tangent>& tangents()
{
    static const Candidates<Tangent> all = {
        {by_the_farthest_axis, by_a_swap, without_a_root, by_projection},
        ordinary_tangents,
        special_tangents};
    return all;
}

} // namespace rigor::testing
