// SPDX-License-Identifier: MIT
// Contacts of random pairs of shapes against their distance by brute force: the least exact
// distance from one shape to points of the other's surface, searched downhill from the nearest
// samples. One shape may be a hundred times as large as the other, and ten times as long as wide.
#include "framework/rigid/contact_shapes.hpp"

#include "geometry/meshes/triangle.hpp"

#include <algorithm>
#include <array>

namespace overlap {

using namespace rigor;
using namespace rigor::testing;

namespace {

struct Drawn {
    std::string name;
    Shape shape;
    double size = 1; // [m]
    bool is_mesh() const { return std::holds_alternative<Mesh>(shape); }
};

double power(Random& random, double low, double high)
{
    return std::pow(10, random.uniform(low, high));
}

constexpr int exact_shapes = 7; // kinds with an exact distance; all others are meshes

Drawn drawn(int kind, Random& random)
{
    const double s = power(random, -1, 1), a = power(random, -1, 0), b = power(random, -1, 0);
    const bool is_flat = random.uniform(0, 1) < 0.5;
    switch (kind) {
    case 0:
        return {"sphere", Sphere{s}, s};
    case 1:
        return {"capsule", Capsule{s * a, s * b}, s};
    case 2:
        return {"torus", Torus{s, 0.9 * s * a}, s};
    case 3:
        return {"box", Box{{s * a, s * b, s}}, s};
    case 4:
        return {"cylinder", is_flat ? Cylinder{s, s * a} : Cylinder{s * a, s}, s};
    case 5:
        return {"cone", is_flat ? Cone{s, s * a} : Cone{s * a, s}, s};
    case 6:
        return {"ellipsoid", Ellipsoid{{s * a, s * b, s}}, s};
    default: {
        const NamedShape& mesh = all_shapes()[kind];
        return {mesh.name, mesh.shape};
    }
    }
}

Vector3d on_surface(const Drawn& of, const Vector3d& p)
{
    if (of.is_mesh()) return p;
    const SurfaceDistance out = signed_distance(of.shape, p);
    return p - out.distance * out.normal;
}

std::vector<Vector3d> surface_points(const Drawn& of, Random& random)
{
    constexpr int count = 400;
    const TriangleMesh mesh = fine_mesh(of.shape);
    std::vector<double> area_up_to;
    double area = 0;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        const Triangle triangle = triangle_of(mesh, t);
        area += (triangle.b - triangle.a).cross(triangle.c - triangle.a).norm();
        area_up_to.push_back(area);
    }
    std::vector<Vector3d> points;
    for (int i = 0; i < count; ++i) {
        const auto at =
            std::lower_bound(area_up_to.begin(), area_up_to.end() - 1, random.uniform(0, area));
        const Triangle t = triangle_of(mesh, static_cast<int>(at - area_up_to.begin()));
        double u = random.uniform(0, 1), v = random.uniform(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        points.push_back(on_surface(of, t.a + u * (t.b - t.a) + v * (t.c - t.a)));
    }
    for (const Vector3d& vertex : mesh.vertices)
        if (mesh.vertices.size() < 500) points.push_back(on_surface(of, vertex));
    return points;
}

struct Placed {
    Drawn drawn;
    Pose pose;
    std::vector<Vector3d> points;
};

// The least signed distance of a point of the second surface to the first shape.
double least_distance(const Placed& first, const Placed& second, Random& random)
{
    const auto distance = [&](const Vector3d& p) {
        return signed_distance(first.drawn.shape,
                               first.pose.R.transpose() * (second.pose * p - first.pose.X))
            .distance;
    };
    constexpr std::size_t starts = 6;
    std::vector<std::pair<double, Vector3d>> nearest;
    for (const Vector3d& p : second.points)
        nearest.emplace_back(distance(p), p);
    std::partial_sort(nearest.begin(), nearest.begin() + starts, nearest.end(),
                      [](const auto& a, const auto& b) { return a.first < b.first; });
    double least = nearest[0].first;
    if (second.drawn.is_mesh()) return least;
    for (std::size_t k = 0; k < starts; ++k) {
        auto [d, p] = nearest[k];
        double reach = 0.1 * second.drawn.size;
        for (int i = 0; i < 150; ++i) {
            const Vector3d next = on_surface(second.drawn, p + reach * random.vector());
            const double there = distance(next);
            reach *= there < d ? 1.5 : 0.8;
            if (there < d) d = there, p = next;
        }
        least = std::min(least, d);
    }
    return least;
}

// Two shapes whose surfaces nearly touch or overlap somewhere; a fifth of them are aligned.
std::array<Placed, 2> random_pair(Random& random)
{
    std::array<Placed, 2> pair;
    const double kinds[] = {static_cast<double>(all_shapes().size()), exact_shapes};
    for (int i = 0; i < 2; ++i) {
        pair[i].drawn = drawn(static_cast<int>(random.uniform(0, kinds[i])), random);
        pair[i].points = surface_points(pair[i].drawn, random);
        pair[i].pose.R = random.rotation();
    }
    if (random.uniform(0, 1) < 0.2) pair[1].pose.R = pair[0].pose.R;
    const auto some_point = [&](const Placed& placed) {
        return placed.pose * placed.points[static_cast<int>(random.uniform(0, 400))];
    };
    const double small = std::min(pair[0].drawn.size, pair[1].drawn.size);
    pair[1].pose.X = some_point(pair[0]) - some_point(pair[1]) +
                     power(random, -6, -1) * small * random.unit_vector();
    return pair;
}

// The overlap from which on a pair must have a contact: the spacing of a mesh's surface points, and
// 0.4 % of the smaller shape where both distances are exact [m].
double found_below(const Drawn& shape, double small)
{
    const Mesh* mesh = std::get_if<Mesh>(&shape.shape);
    return mesh ? mesh->solid->surface().spacing() : 0.004 * small;
}

void check_pairs(unsigned first, unsigned last)
{
    for (unsigned seed = first; seed < last; ++seed) {
        Random random(seed);
        const auto [a, b] = random_pair(random);
        CAPTURE(seed, a.drawn.name, b.drawn.name);
        double distance = least_distance(b, a, random);
        if (!a.drawn.is_mesh()) distance = std::min(distance, least_distance(a, b, random));
        const double small = std::min(a.drawn.size, b.drawn.size);
        const double tolerance = found_below(a.drawn, small), reach = small / 2;
        const auto touches = touches_of(a.drawn.shape, a.pose, b.drawn.shape, b.pose, reach);
        for (const Contact& t : touches) {
            REQUIRE(t.point.allFinite());
            REQUIRE(std::isfinite(t.gap));
            REQUIRE_THAT(t.normal.norm(), IsClose(1.0, Rounding(256)));
        }
        if (distance < -tolerance) REQUIRE(deepest(touches) < 0);
        if (a.drawn.is_mesh()) continue; // its sampled points alone give no exact distance
        if (distance > tolerance) REQUIRE(deepest(touches) > 0.98 * distance - tolerance);
        if (distance > 0 && distance < reach - tolerance)
            REQUIRE(deepest(touches) < distance + tolerance);
    }
}

} // namespace

TEST_CASE("contact: random pairs overlap where brute force says so", "[rigid]")
{
    check_pairs(0, 300);
}

TEST_CASE("contact: a hundred thousand random pairs overlap where brute force says so", "[.long]")
{
    check_pairs(0, 100'000);
}

} // namespace overlap
