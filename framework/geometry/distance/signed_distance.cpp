// SPDX-License-Identifier: MIT
// Computes the exact distance of a point to a shape, and its gradient. Shapes of revolution are
// solved in the half-plane of distance from the axis and height, ellipsoids by Newton's method
// (Eberly 2013, "Distance from a point to an ellipse, an ellipsoid, or a hyperellipsoid"). For a
// cylinder and a cone, points inside are treated before points near sides, edges and tips.
#include "geometry/distance/signed_distance.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

namespace rigor {

namespace {

// Cylindrical coordinates about the y axis: distance from the axis, height, and the direction away
// from the axis.
struct Cylindrical {
    explicit Cylindrical(const Vector3d& p) : distance(std::hypot(p.x(), p.z())), height(p.y())
    {
        if (distance > 0) outward = Vector3d(p.x(), 0, p.z()) / distance;
    }
    Vector3d direction(double along_outward, double along_y) const
    {
        return along_outward * outward + along_y * Vector3d::UnitY();
    }
    double distance, height;
    Vector3d outward = Vector3d::UnitX();
};

// The signed distance to a circle around the point with the distance a from the axis and the height
// b, in the half-plane of p: the distance to the center minus the radius.
SurfaceDistance from_core(const Cylindrical& p, double a, double b, double radius)
{
    const double d = std::hypot(p.distance - a, p.height - b);
    const Vector3d n = d > 0 ? p.direction((p.distance - a) / d, (p.height - b) / d) : p.outward;
    return {d - radius, n};
}

} // namespace

SurfaceDistance signed_distance(const Sphere& sphere, const Vector3d& p)
{
    const double d = p.norm();
    return {d - sphere.radius, d > 0 ? Vector3d(p / d) : Vector3d::UnitY()};
}

SurfaceDistance signed_distance(const Capsule& capsule, const Vector3d& p)
{
    const double end = capsule.height / 2;
    return from_core(Cylindrical(p), 0, std::clamp(p.y(), -end, end), capsule.radius);
}

SurfaceDistance signed_distance(const Torus& torus, const Vector3d& p)
{
    return from_core(Cylindrical(p), torus.radius, 0, torus.tube);
}

SurfaceDistance signed_distance(const Box& box, const Vector3d& p)
{
    const Vector3d half = box.size / 2;
    const Vector3d nearest = p.cwiseMax(-half).cwiseMin(half);
    const double outside = (p - nearest).norm();
    if (outside > 0) return {outside, (p - nearest) / outside};
    int axis = 0;
    const double inside = (half - p.cwiseAbs()).minCoeff(&axis);
    return {-inside, p[axis] < 0 ? Vector3d(-Vector3d::Unit(axis)) : Vector3d::Unit(axis)};
}

SurfaceDistance signed_distance(const Cylinder& cylinder, const Vector3d& p)
{
    const Cylindrical at(p);
    const double up = at.height < 0 ? -1 : 1;
    const double a = at.distance - cylinder.radius, b = std::abs(at.height) - cylinder.height / 2;
    if (a <= 0 && b <= 0) // inside: the nearer one of the side and the cap
        return a > b ? SurfaceDistance{a, at.outward} : SurfaceDistance{b, at.direction(0, up)};
    const double d = std::hypot(std::max(a, 0.0), std::max(b, 0.0));
    return {d, at.direction(std::max(a, 0.0) / d, up * std::max(b, 0.0) / d)};
}

SurfaceDistance signed_distance(const Cone& cone, const Vector3d& p)
{
    const Cylindrical at(p);
    const double base = -cone.height / 4;
    const double length = std::hypot(cone.radius, cone.height);
    // Coordinates of p relative to the rim [m]: x away from the axis, y upwards; `along` the slope
    // towards the tip, and `away` from the cone, perpendicular to the slope.
    const double x = at.distance - cone.radius, y = at.height - base;
    const double along = (-cone.radius * x + cone.height * y) / length;
    const double away = (cone.height * x + cone.radius * y) / length;
    const SurfaceDistance slope{away, at.direction(cone.height / length, cone.radius / length)};
    const SurfaceDistance floor{-y, at.direction(0, -1)};
    if (away <= 0 && y >= 0) return slope.distance > floor.distance ? slope : floor;
    if (y < 0 && x <= 0) return floor;
    if (along >= length) return from_core(at, 0, base + cone.height, 0);
    if (along > 0 && away > 0) return slope;
    return from_core(at, cone.radius, base, 0);
}

namespace {

// The nearest point x of an ellipsoid with radii e₀ ≥ e₁ ≥ e₂ to a point y with no coordinate < 0:
// xᵢ = rᵢ yᵢ/(u + rᵢ - 1) with rᵢ = (eᵢ/e₂)². Here u > 0 is the root of the decreasing and convex
// function F(u) = Σ ((eᵢ/e₂) zᵢ/(u + rᵢ - 1))² - 1 with zᵢ = yᵢ/e₂.
Vector3d nearest_in_octant(const Vector3d& e, const Vector3d& y)
{
    // A coordinate of 0 is replaced by a number too small to change the result, because x₂ could be
    // 0/0 otherwise.
    constexpr double tiny = 1e-150; // its square is still above 0
    const Vector3d z = (y / e[2]).cwiseMax(tiny);
    const Vector3d ratio = e / e[2];
    const Vector3d r = ratio.cwiseAbs2();
    double u = 0; // start left of the root, where Newton's method does not overshoot
    for (int i = 0; i < 3; ++i)
        u = std::max(u, ratio[i] * z[i] - (r[i] - 1));
    constexpr int most_newton_steps = 200; // limits the time; the method converges quadratically
    for (int step = 0; step < most_newton_steps; ++step) {
        double F = -1, slope = 0;
        for (int i = 0; i < 3; ++i) {
            const double below = u + (r[i] - 1);
            const double term = ratio[i] * z[i] / below;
            F += term * term;
            slope -= 2 * term * term / below;
        }
        const double next = u - F / slope;
        if (!(next > u)) break;
        u = next;
    }
    Vector3d x;
    for (int i = 0; i < 3; ++i)
        x[i] = e[2] * r[i] * z[i] / (u + (r[i] - 1));
    return x;
}

} // namespace

SurfaceDistance signed_distance(const Ellipsoid& ellipsoid, const Vector3d& p)
{
    std::array<int, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int i, int j) {
        return ellipsoid.radii[i] > ellipsoid.radii[j] ||
               (ellipsoid.radii[i] == ellipsoid.radii[j] && i < j);
    });
    Vector3d e, y;
    for (int i = 0; i < 3; ++i) {
        e[i] = ellipsoid.radii[order[i]];
        y[i] = std::abs(p[order[i]]);
    }
    const Vector3d x = nearest_in_octant(e, y);
    const Vector3d gradient = x.cwiseQuotient(e).cwiseQuotient(e).normalized();
    SurfaceDistance result;
    for (int i = 0; i < 3; ++i)
        result.normal[order[i]] = p[order[i]] < 0 ? -gradient[i] : gradient[i];
    result.distance = (y - x).dot(gradient); // y - x is along the normal
    return result;
}

SurfaceDistance signed_distance(const Plane&, const Vector3d& p)
{
    return {p.y(), Vector3d::UnitY()};
}

namespace {

struct DistanceTo {
    const Vector3d& p;
    template <class Round> SurfaceDistance operator()(const Round& shape) const
    {
        // The type of this pointer selects the overload for exactly this shape. If a shape had no
        // overload, a plain call would convert it to `Shape`, and recurse without end.
        constexpr SurfaceDistance (*overload)(const Round&, const Vector3d&) = signed_distance;
        return overload(shape, p);
    }
    SurfaceDistance operator()(const Mesh&) const
    {
        assert(false && "a mesh has its distance from a level set");
        return {};
    }
};

} // namespace

SurfaceDistance signed_distance(const Shape& shape, const Vector3d& p)
{
    return std::visit(DistanceTo{p}, shape);
}

} // namespace rigor
