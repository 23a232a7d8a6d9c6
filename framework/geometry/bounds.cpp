// SPDX-License-Identifier: MIT
#include "geometry/bounds.hpp"

namespace rigor {

Bounds bounds_of(const Shape& shape, const Pose& pose)
{
    Vector3d extent = Vector3d::Constant(std::numeric_limits<double>::infinity());
    if (const Sphere* sphere = std::get_if<Sphere>(&shape)) extent.setConstant(sphere->radius);
    if (const Box* box = std::get_if<Box>(&shape)) extent = pose.R.cwiseAbs() * box->size / 2;

    Bounds bounds;
    bounds.low = pose.X - extent;
    bounds.high = pose.X + extent;
    return bounds;
}

double bounding_radius(const Part& part)
{
    double radius = std::numeric_limits<double>::infinity();
    if (const Sphere* sphere = std::get_if<Sphere>(&part.shape)) radius = sphere->radius;
    if (const Box* box = std::get_if<Box>(&part.shape)) radius = box->size.norm() / 2;
    return part.position.norm() + radius;
}

} // namespace rigor
