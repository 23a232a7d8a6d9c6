// SPDX-License-Identifier: MIT
// Depth of the overlap of spheres, boxes and planes. A signed separation is computed for each
// pair of shapes in closed form. For two boxes it is the largest one along the 15 axes of
// Gottschalk, Lin and Manocha (1996). The depth is the negative separation, or 0.
#include "support/shapes/depth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace rigor::testing {

namespace {

// Signed distance of a point to a box, negative inside.
double distance_to_box(const Box& box, const Pose& pose, const Vector3d& x)
{
    const Vector3d p = pose.R.transpose() * (x - pose.X);
    const Vector3d d = p.cwiseAbs() - box.size / 2;
    return d.maxCoeff() < 0 ? d.maxCoeff() : d.cwiseMax(0).norm();
}

double separation(const Sphere& a, const Pose& at, const Sphere& b, const Pose& bt)
{
    return (at.X - bt.X).norm() - a.radius - b.radius;
}

double separation(const Sphere& a, const Pose& at, const Box& b, const Pose& bt)
{
    return distance_to_box(b, bt, at.X) - a.radius;
}

double separation(const Box& a, const Pose& at, const Sphere& b, const Pose& bt)
{
    return separation(b, bt, a, at);
}

double separation(const Box& a, const Pose& at, const Box& b, const Pose& bt)
{
    return box_separation(a, at, b, bt);
}

double separation(const Sphere& a, const Pose& at, const Plane&, const Pose& bt)
{
    return bt.R.col(1).dot(at.X - bt.X) - a.radius;
}

double separation(const Box& a, const Pose& at, const Plane&, const Pose& bt)
{
    const Vector3d n = bt.R.col(1);
    return n.dot(at.X - bt.X) - (at.R.transpose() * n).cwiseAbs().dot(a.size / 2);
}

double separation(const Plane& a, const Pose& at, const Sphere& b, const Pose& bt)
{
    return separation(b, bt, a, at);
}

double separation(const Plane& a, const Pose& at, const Box& b, const Pose& bt)
{
    return separation(b, bt, a, at);
}

double separation(const Plane&, const Pose&, const Plane&, const Pose&)
{
    return std::numeric_limits<double>::infinity();
}

} // namespace

double box_separation(const Box& box1, const Pose& pose1, const Box& box2, const Pose& pose2)
{
    const Matrix3d &A = pose1.R, &B = pose2.R;
    const Vector3d d = pose2.X - pose1.X;
    const auto along = [&](const Vector3d& l) {
        return std::abs(l.dot(d)) - (A.transpose() * l).cwiseAbs().dot(box1.size) / 2 -
               (B.transpose() * l).cwiseAbs().dot(box2.size) / 2;
    };
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        most = std::max({most, along(A.col(i)), along(B.col(i))});
        for (int j = 0; j < 3; ++j) {
            const Vector3d l = A.col(i).cross(B.col(j));
            constexpr double parallel = 1e-6; // sine of an angle; such edges give no axis
            const double length = l.norm();
            if (length > parallel) most = std::max(most, along(l / length));
        }
    }
    return most;
}

double overlap_depth(const Shape& shape1, const Pose& pose1, const Shape& shape2, const Pose& pose2)
{
    const double gap = std::visit(
        [&](const auto& a, const auto& b) -> double {
            if constexpr (requires { separation(a, pose1, b, pose2); })
                return separation(a, pose1, b, pose2);
            else
                throw std::invalid_argument("expected spheres, boxes and planes");
        },
        shape1, shape2);
    return std::max(0.0, -gap);
}

} // namespace rigor::testing
