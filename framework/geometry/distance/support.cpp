// SPDX-License-Identifier: MIT
// Support functions of the convex shapes (Gilbert, Johnson and Keerthi 1988, "A fast procedure for
// computing the distance between complex objects") and the features at the support point. Three
// visitors compute, in this order, the support point, the feature, and the normals of the faces.
#include "geometry/distance/support.hpp"

#include "geometry/shapes/solid_mesh.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

// The unit vector away from the y axis towards d; the x axis if d is along y.
Vector3d outward(const Vector3d& d)
{
    const double r = std::hypot(d.x(), d.z());
    return r > 0 ? Vector3d(d.x() / r, 0, d.z() / r) : Vector3d::UnitX();
}

// A point of a circle about y, at `i` eighths of a turn from the direction `first`.
Vector3d rim_point(double radius, double height, const Vector3d& first, int i)
{
    const double angle = std::numbers::pi / 4 * i, c = std::cos(angle), s = std::sin(angle);
    return {radius * (c * first.x() - s * first.z()), height,
            radius * (s * first.x() + c * first.z())};
}

Feature point(const Vector3d& p)
{
    Feature feature;
    feature.add(p);
    return feature;
}

// Eight points of a circle about y. One of them is the farthest along d, unless d is along y up to
// rounding: then all are equally far.
Feature circle(double radius, double height, const Vector3d& d)
{
    // Sine of the angle between d and the y axis. An angle up to this is only rounding.
    constexpr double perpendicular = 1e-6;
    const bool is_tilted = std::hypot(d.x(), d.z()) > perpendicular;
    const Vector3d first = is_tilted ? outward(d) : Vector3d::UnitX();
    Feature feature;
    for (int i = 0; i < 8; ++i)
        feature.add(rim_point(radius, height, first, i));
    return feature;
}

struct SupportAlong {
    const Vector3d& d;

    Vector3d operator()(const Box& b) const
    {
        return {d.x() < 0 ? -b.size.x() / 2 : b.size.x() / 2,
                d.y() < 0 ? -b.size.y() / 2 : b.size.y() / 2,
                d.z() < 0 ? -b.size.z() / 2 : b.size.z() / 2};
    }
    Vector3d operator()(const Cylinder& c) const
    {
        const double r = std::hypot(d.x(), d.z()), y = d.y() < 0 ? -c.height / 2 : c.height / 2;
        if (!(r > 0)) return {0, y, 0};
        return {c.radius * d.x() / r, y, c.radius * d.z() / r};
    }
    Vector3d operator()(const Cone& c) const
    {
        const double r = std::hypot(d.x(), d.z());
        if (c.radius * r < c.height * d.y()) return {0, 0.75 * c.height, 0};
        if (!(r > 0)) return {0, -0.25 * c.height, 0};
        return {c.radius * d.x() / r, -0.25 * c.height, c.radius * d.z() / r};
    }
    Vector3d operator()(const Ellipsoid& e) const
    {
        const Vector3d scaled = e.radii.cwiseProduct(d);
        const double length = scaled.norm();
        if (!(length > 0)) return {0, e.radii.y(), 0};
        return e.radii.cwiseProduct(scaled) / length;
    }
    Vector3d operator()(const Mesh& m) const { return m.solid->hull().support(d); }
    template <class Other> Vector3d operator()(const Other&) const
    {
        assert(false && "no support function for this shape");
        return Vector3d::Zero();
    }
};

struct FeatureAlong {
    const Vector3d& d; // unit

    Feature operator()(const Box& b) const
    {
        const Vector3d half = b.size / 2;
        Vector3d corner = SupportAlong{d}(b);
        int k = 0;
        const double most = d.cwiseAbs().maxCoeff(&k), least = d.cwiseAbs().minCoeff();
        if (most > Feature::facing_cosine) {
            const int u = (k + 1) % 3, v = (k + 2) % 3;
            Feature face;
            for (int i = 0; i < 4; ++i) {
                corner[u] = i == 0 || i == 3 ? half[u] : -half[u];
                corner[v] = i < 2 ? half[v] : -half[v];
                face.add(corner);
            }
            return face;
        }
        if (least > std::sqrt(1 - Feature::facing_cosine * Feature::facing_cosine))
            return point(corner);
        d.cwiseAbs().minCoeff(&k);
        Feature edge = point(corner);
        corner[k] = -corner[k];
        edge.add(corner);
        return edge;
    }
    Feature operator()(const Cylinder& c) const
    {
        const double half = c.height / 2;
        if (std::abs(d.y()) > Feature::facing_cosine)
            return circle(c.radius, d.y() < 0 ? -half : half, d);
        const Vector3d out = c.radius * outward(d);
        Feature side = point(out + Vector3d(0, d.y() < 0 ? -half : half, 0));
        if (outward(d).dot(d) > Feature::facing_cosine)
            side.add(out - Vector3d(0, d.y() < 0 ? -half : half, 0));
        return side;
    }
    Feature operator()(const Cone& c) const
    {
        if (d.y() < -Feature::facing_cosine) return circle(c.radius, -0.25 * c.height, d);
        const Vector3d out = outward(d), tip(0, 0.75 * c.height, 0);
        const Vector3d slope = (c.height * out + Vector3d(0, c.radius, 0)).normalized();
        if (slope.dot(d) <= Feature::facing_cosine) return point(SupportAlong{d}(c));
        Feature side = point(c.radius * out - Vector3d(0, 0.25 * c.height, 0));
        side.add(tip);
        return side;
    }
    Feature operator()(const Mesh& m) const { return m.solid->hull().feature_towards(d); }
    template <class Other> Feature operator()(const Other& shape) const
    {
        return point(SupportAlong{d}(shape));
    }
};

struct FaceNormals {
    const Vector3d& towards;
    std::vector<Vector3d>& normals;

    void operator()(const Box&) const
    {
        for (int i = 0; i < 3; ++i) {
            normals.push_back(Vector3d::Unit(i));
            normals.push_back(-Vector3d::Unit(i));
        }
    }
    void operator()(const Cylinder&) const
    {
        normals.push_back(Vector3d::UnitY());
        normals.push_back(-Vector3d::UnitY());
        normals.push_back(outward(towards));
    }
    void operator()(const Cone& c) const
    {
        normals.push_back(-Vector3d::UnitY());
        normals.push_back((c.height * outward(towards) + Vector3d(0, c.radius, 0)).normalized());
    }
    void operator()(const Mesh& m) const
    {
        const std::vector<Vector3d>& faces = m.solid->hull().face_normals();
        normals.insert(normals.end(), faces.begin(), faces.end());
    }
    template <class Other> void operator()(const Other&) const {}
};

} // namespace

bool is_convex_solid(const Shape& shape)
{
    if (const Mesh* mesh = std::get_if<Mesh>(&shape)) return mesh->solid->is_convex();
    return std::holds_alternative<Box>(shape) || std::holds_alternative<Cylinder>(shape) ||
           std::holds_alternative<Cone>(shape) || std::holds_alternative<Ellipsoid>(shape);
}

Vector3d support(const Shape& shape, const Vector3d& direction)
{
    return std::visit(SupportAlong{direction}, shape);
}

Feature feature_towards(const Shape& shape, const Vector3d& direction)
{
    return std::visit(FeatureAlong{direction}, shape);
}

void add_face_normals(const Shape& shape, const Vector3d& towards, std::vector<Vector3d>& normals)
{
    std::visit(FaceNormals{towards, normals}, shape);
}

} // namespace rigor
