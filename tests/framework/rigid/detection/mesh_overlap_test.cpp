// SPDX-License-Identifier: MIT
// Contacts of random pairs of meshes against their distance by brute force: points of each surface
// in the exact signed distance of the other mesh, which is the distance of the nearest triangle
// with the sign of the winding number (Van Oosterom and Strackee 1983). One mesh may be five times
// as large as the other.
#include "framework/rigid/contact_shapes.hpp"

#include "geometry/meshes/triangle.hpp"
#include "support/sweep.hpp"

#include <algorithm>
#include <array>

namespace mesh_overlap {

using namespace rigor;
using namespace rigor::testing;

namespace {

struct NamedMesh {
    std::string name;
    std::shared_ptr<const SolidMesh> solid;
};

const std::vector<NamedMesh>& all_meshes()
{
    static const std::vector<NamedMesh> all = [] {
        const std::vector<std::pair<std::string, TriangleMesh>> shapes = {
            {"ring", ring_mesh(0.3, 0.5, 0.25, 48)},
            {"cross", cross_mesh(1, 0.3)},
            {"bowl", bowl_mesh(0.5, 0.1, 48)},
            {"gear", gear_mesh(12, 0.5, 0.15, 0.2)},
            {"angle", angle_mesh({0.8, 0.8, 0.4}, 0.25)},
            {"stone", voussoir_mesh(0.2, 0.6, 60, 0.5)},
            {"torus", torus_mesh(0.4, 0.13, 24, 12)},
            {"dented box", dented_box({0.6, 0.5, 0.8})}};
        std::vector<NamedMesh> meshes;
        for (const double size : {0.2, 1.0})
            for (const auto& [name, shape] : shapes) {
                TriangleMesh scaled = shape;
                for (Vector3d& v : scaled.vertices)
                    v *= size;
                meshes.push_back({name, std::make_shared<SolidMesh>(scaled)});
            }
        return meshes;
    }();
    return all;
}

// The solid angle of a triangle seen from p, positive from inside.
double solid_angle(const Triangle& t, const Vector3d& p)
{
    const Vector3d a = t.a - p, b = t.b - p, c = t.c - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    return 2 * std::atan2(a.dot(b.cross(c)),
                          la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

double signed_distance(const TriangleMesh& mesh, const Vector3d& p)
{
    double squared = 1e300, angle = 0;
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
        const Triangle t = triangle_of(mesh, i);
        squared = std::min(squared, (nearest_on(t, p).point - p).squaredNorm());
        angle += solid_angle(t, p);
    }
    const bool is_inside = angle > 2 * std::numbers::pi;
    return is_inside ? -std::sqrt(squared) : std::sqrt(squared);
}

struct Placed {
    NamedMesh mesh;
    Pose pose;
    std::vector<Vector3d> points; // on its surface, in the world

    double distance(const Vector3d& p) const
    {
        return signed_distance(mesh.solid->mesh(), pose.R.transpose() * (p - pose.X));
    }
};

std::vector<Vector3d> surface_points(const TriangleMesh& mesh, Random& random)
{
    constexpr int count = 150;
    std::vector<double> area_up_to;
    double area = 0;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
        area_up_to.push_back(area += triangle_of(mesh, t).area_normal().norm());
    std::vector<Vector3d> points;
    for (int i = 0; i < count; ++i) {
        const auto at =
            std::lower_bound(area_up_to.begin(), area_up_to.end() - 1, random.uniform(0, area));
        const Triangle t = triangle_of(mesh, static_cast<int>(at - area_up_to.begin()));
        double u = random.uniform(0, 1), v = random.uniform(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        points.push_back(t.a + u * (t.b - t.a) + v * (t.c - t.a));
    }
    return points;
}

// Two meshes whose surfaces nearly touch or overlap somewhere; a fifth of them are aligned.
std::array<Placed, 2> random_pair(Random& random)
{
    std::array<Placed, 2> pair;
    for (Placed& placed : pair) {
        const std::vector<NamedMesh>& all = all_meshes();
        placed.mesh = all[static_cast<int>(random.uniform(0, static_cast<double>(all.size())))];
        placed.pose.R = random.rotation();
        placed.points = surface_points(placed.mesh.solid->mesh(), random);
    }
    if (random.uniform(0, 1) < 0.2) pair[1].pose.R = pair[0].pose.R;
    const auto some_point = [&](const Placed& placed) {
        return placed.pose * placed.points[static_cast<int>(random.uniform(0, 100))];
    };
    const double offset = std::pow(10, random.uniform(-6, -1)) * pair[0].mesh.solid->radius();
    pair[1].pose.X = some_point(pair[0]) - some_point(pair[1]) + offset * random.unit_vector();
    for (Placed& placed : pair)
        for (Vector3d& p : placed.points)
            p = placed.pose * p;
    return pair;
}

void check_pairs(unsigned first, unsigned last)
{
    Sweep sweep;
    for (unsigned seed = first; seed < last; ++seed) {
        if (!sweep.takes_next()) continue;
        Random random(seed);
        const auto [a, b] = random_pair(random);
        CAPTURE(seed, a.mesh.name, b.mesh.name);
        double distance = 1e300; // an upper bound
        for (const Vector3d& p : a.points)
            distance = std::min(distance, b.distance(p));
        for (const Vector3d& p : b.points)
            distance = std::min(distance, a.distance(p));
        // Between the surface points, one spacing apart, a level set rounds off edges.
        const double spacing =
            std::max(a.mesh.solid->surface().spacing(), b.mesh.solid->surface().spacing());
        const double reach = spacing + std::min(a.mesh.solid->radius(), b.mesh.solid->radius());
        // Contacts of two convex meshes that overlap far lie where their faces are clipped.
        const bool has_level_set = !a.mesh.solid->is_convex() || !b.mesh.solid->is_convex();
        const std::vector<Contact> touches =
            touches_of(Mesh{a.mesh.solid}, a.pose, Mesh{b.mesh.solid}, b.pose, reach);
        for (const Contact& t : touches) {
            REQUIRE(t.point.allFinite());
            REQUIRE(std::isfinite(t.gap));
            REQUIRE_THAT(t.normal.norm(), IsClose(1.0, Rounding(256)));
            // A contact has two points, half the gap to each side of it. One of them lies on the
            // surface of one solid and is no farther from the other solid than the gap. If the
            // solids overlap, it lies in the other solid.
            double outside = 1e300;
            for (const double half : {-t.gap / 2, t.gap / 2}) {
                const Vector3d x = t.point + half * t.normal;
                outside = std::min(outside, std::max(a.distance(x), b.distance(x)));
            }
            CAPTURE(t.gap, spacing);
            if (has_level_set) REQUIRE(outside < std::max(t.gap, 0.0) + spacing);
        }
        if (distance < -spacing) REQUIRE(deepest(touches) < 0);
        if (distance > 0 && distance < reach - spacing)
            REQUIRE(deepest(touches) < distance + spacing);
    }
}

} // namespace

TEST_CASE("contact: random meshes overlap where brute force says so", "[rigid]")
{
    check_pairs(0, 100);
}

TEST_CASE("contact: twenty thousand pairs of meshes overlap where brute force says so", "[.long]")
{
    check_pairs(0, 20'000);
}

} // namespace mesh_overlap
