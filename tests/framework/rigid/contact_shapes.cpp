// SPDX-License-Identifier: MIT
#include "framework/rigid/contact_shapes.hpp"

#include "geometry/meshes/triangle.hpp"

namespace rigor::testing {

namespace {

constexpr double pixel = 0.004; // [m]
constexpr int side = 512;       // the map covers 2 m

// The highest point of a mesh above each point of the xy plane.
class HeightMap {
public:
    HeightMap() : heights_(static_cast<std::size_t>(side) * side, -1e300) {}

    void draw(const Triangle& t)
    {
        const Vector3d u = t.b - t.a, v = t.c - t.a;
        const double area = u.x() * v.y() - u.y() * v.x();
        if (std::abs(area) < 1e-12) return;
        const Bounds box = t.bounds();
        const double slack = 1e-9;
        for (int j = cell(box.low.y()); j <= cell(box.high.y()) + 1; ++j)
            for (int i = cell(box.low.x()); i <= cell(box.high.x()) + 1; ++i) {
                const double x = (i - side / 2) * pixel - t.a.x(),
                             y = (j - side / 2) * pixel - t.a.y();
                const double s = (x * v.y() - y * v.x()) / area, r = (u.x() * y - u.y() * x) / area;
                if (s < -slack || r < -slack || s + r > 1 + slack) continue;
                double& height = heights_[static_cast<std::size_t>(j) * side + i];
                height = std::max(height, t.a.z() + s * u.z() + r * v.z());
            }
    }

    // The largest sum of the heights of two maps.
    double meeting(const HeightMap& other) const
    {
        double most = -1e300;
        for (std::size_t i = 0; i < heights_.size(); ++i)
            most = std::max(most, heights_[i] + other.heights_[i]);
        return most;
    }

private:
    static int cell(double x) { return static_cast<int>(std::floor(x / pixel)) + side / 2; }
    std::vector<double> heights_;
};

struct FineMesh {
    TriangleMesh operator()(const Sphere& s) const { return icosphere(s.radius, 5); }
    TriangleMesh operator()(const Capsule& c) const
    {
        std::vector<PlanePoint> profile;
        for (int i = 0; i <= 64; ++i) {
            const double angle = std::numbers::pi * (i - 32) / 64;
            const double y = c.radius * std::sin(angle) + (i < 32 ? -0.5 : 0.5) * c.height;
            profile.push_back({i == 0 || i == 64 ? 0 : c.radius * std::cos(angle), y});
        }
        return surface_of_revolution(profile, 96);
    }
    TriangleMesh operator()(const Torus& t) const { return torus_mesh(t.radius, t.tube, 96, 48); }
    TriangleMesh operator()(const Box& b) const { return box_mesh(b.size); }
    TriangleMesh operator()(const Cylinder& c) const
    {
        const double y = c.height / 2;
        return surface_of_revolution({{0, -y}, {c.radius, -y}, {c.radius, y}, {0, y}}, 192);
    }
    TriangleMesh operator()(const Cone& c) const
    {
        const double y = -c.height / 4;
        return surface_of_revolution({{0, y}, {c.radius, y}, {0, y + c.height}}, 192);
    }
    TriangleMesh operator()(const Ellipsoid& e) const
    {
        TriangleMesh ball = icosphere(1, 5);
        for (Vector3d& v : ball.vertices)
            v = v.cwiseProduct(e.radii);
        return ball;
    }
    TriangleMesh operator()(const Mesh& m) const { return m.solid->mesh(); }
    TriangleMesh operator()(const Plane&) const { return {}; }
};

} // namespace

TriangleMesh fine_mesh(const Shape& shape)
{
    return std::visit(FineMesh{}, shape);
}

double meeting_distance(const Shape& first, const Pose& pose, const Shape& second,
                        const Matrix3d& R, const Vector3d& away)
{
    const Vector3d u = away.unitOrthogonal();
    Matrix3d view; // frame with `away` as its z axis
    view << u, away.cross(u), away;
    // The upper side of the first shape, and the lower side of the second one seen from below.
    const auto draw = [&](const Shape& shape, const Matrix3d& rotation, double up) {
        const TriangleMesh triangles = fine_mesh(shape);
        HeightMap map;
        for (int t = 0; t < static_cast<int>(triangles.triangles.size()); ++t) {
            Triangle triangle = triangle_of(triangles, t);
            for (Vector3d* p : {&triangle.a, &triangle.b, &triangle.c}) {
                *p = view.transpose() * (rotation * *p);
                p->z() *= up;
            }
            map.draw(triangle);
        }
        return map;
    };
    return draw(first, pose.R, 1).meeting(draw(second, R, -1));
}

std::vector<Vector3d> corners(const Box& box, const Pose& pose)
{
    std::vector<Vector3d> all;
    for (int i = 0; i < 8; ++i)
        all.push_back(
            pose *
            Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1).cwiseProduct(box.size / 2));
    return all;
}

TriangleMesh dented_box(const Vector3d& size)
{
    TriangleMesh box = box_mesh(size);
    const Vector3d middle(0, size.y() / 2, 0);
    const auto lid = std::find_if(box.triangles.begin(), box.triangles.end(), [&](const auto& t) {
        return box.vertices[t[0]].y() > 0 && box.vertices[t[1]].y() > 0 &&
               box.vertices[t[2]].y() > 0;
    });
    const auto [i, j, k] = *lid;
    const Vector3d center = (box.vertices[i] + box.vertices[j] + box.vertices[k]) / 3;
    box.vertices.push_back(center - Vector3d(0, 0.3 * size.y(), 0));
    *lid = {i, j, 8};
    box.triangles.push_back({j, k, 8});
    box.triangles.push_back({k, i, 8});
    return box;
}

} // namespace rigor::testing
