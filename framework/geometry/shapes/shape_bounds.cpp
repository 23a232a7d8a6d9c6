// SPDX-License-Identifier: MIT
// Computes the bounding box of each shape at a pose, from its half extents along the axes of the
// outer frame, and the radius of a ball that contains the shape. Each of the two is computed by a
// visitor, which has one function for each shape.
#include "geometry/shapes/shape_bounds.hpp"

#include "geometry/shapes/solid_mesh.hpp"

#include <cmath>

namespace rigor {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Bounds about(const Vector3d& center, const Vector3d& extent)
{
    return {center - extent, center + extent};
}

// Half extents of a disc of radius 1 perpendicular to the unit vector `axis`: √(1 − axisᵢ²).
Vector3d disc_extent(const Vector3d& axis)
{
    return (Vector3d::Ones() - axis.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
}

struct BoundsAt {
    const Pose& pose;

    Bounds operator()(const Sphere& s) const { return about(pose.X, Vector3d::Constant(s.radius)); }
    Bounds operator()(const Capsule& c) const
    {
        const Vector3d axis = pose.R.col(1).cwiseAbs();
        return about(pose.X, axis * c.height / 2 + Vector3d::Constant(c.radius));
    }
    Bounds operator()(const Torus& t) const
    {
        return about(pose.X, t.radius * disc_extent(pose.R.col(1)) + Vector3d::Constant(t.tube));
    }
    Bounds operator()(const Box& b) const { return about(pose.X, pose.R.cwiseAbs() * b.size / 2); }
    Bounds operator()(const Cylinder& c) const
    {
        const Vector3d axis = pose.R.col(1);
        return about(pose.X, axis.cwiseAbs() * c.height / 2 + c.radius * disc_extent(axis));
    }
    Bounds operator()(const Cone& c) const
    {
        const Vector3d axis = pose.R.col(1), tip = pose * Vector3d(0, 0.75 * c.height, 0);
        Bounds bounds =
            about(pose * Vector3d(0, -0.25 * c.height, 0), c.radius * disc_extent(axis));
        bounds.include({tip, tip});
        return bounds;
    }
    Bounds operator()(const Ellipsoid& e) const
    {
        return about(pose.X, (pose.R * e.radii.asDiagonal()).rowwise().norm());
    }
    Bounds operator()(const Mesh& m) const
    {
        const Bounds& box = m.solid->bounds();
        return about(pose * ((box.low + box.high) / 2),
                     pose.R.cwiseAbs() * ((box.high - box.low) / 2));
    }
    Bounds operator()(const Plane&) const { return about(pose.X, Vector3d::Constant(infinity)); }
};

struct Radius {
    double operator()(const Sphere& s) const { return s.radius; }
    double operator()(const Capsule& c) const { return c.height / 2 + c.radius; }
    double operator()(const Torus& t) const { return t.radius + t.tube; }
    double operator()(const Box& b) const { return b.size.norm() / 2; }
    double operator()(const Cylinder& c) const { return std::hypot(c.radius, c.height / 2); }
    double operator()(const Cone& c) const
    {
        return std::max(std::hypot(c.radius, c.height / 4), 0.75 * c.height);
    }
    double operator()(const Ellipsoid& e) const { return e.radii.maxCoeff(); }
    double operator()(const Mesh& m) const { return m.solid->center().norm() + m.solid->radius(); }
    double operator()(const Plane&) const { return infinity; }
};

} // namespace

Bounds bounds_of(const Shape& shape, const Pose& pose)
{
    return std::visit(BoundsAt{pose}, shape);
}

double bounding_radius(const Part& part)
{
    if (const Mesh* mesh = std::get_if<Mesh>(&part.shape)) {
        const Vector3d center = rotation_matrix(part.orientation) * mesh->solid->center();
        return (part.position + center).norm() + mesh->solid->radius();
    }
    return part.position.norm() + std::visit(Radius{}, part.shape);
}

} // namespace rigor
