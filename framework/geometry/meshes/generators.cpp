// SPDX-License-Identifier: MIT
// Builds triangle meshes of simple solids, as surfaces of revolution, as extrusions, or vertex by
// vertex. Outlines are divided into triangles by clipping ears (Meisters 1975, "Polygons have
// ears").
#include "geometry/meshes/generators.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace rigor {

namespace {

constexpr double pi = std::numbers::pi;

void add_quad(TriangleMesh& mesh, int a, int b, int c, int d)
{
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
}

// Twice the signed area of the triangle (a, b, c), positive if it is counter-clockwise.
double turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool is_inside(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

// The triangles of a simple counter-clockwise polygon, found by clipping one ear after the other.
// An ear is a counter-clockwise triangle of three successive corners, with no other corner inside
// it or on its border. The next ear is always the one with the largest ratio of its area to the
// squared length of its new edge, which avoids slivers.
std::vector<std::array<int, 3>> triangulated(const std::vector<PlanePoint>& polygon)
{
    std::vector<int> rest(polygon.size());
    for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] = static_cast<int>(i);
    std::vector<std::array<int, 3>> triangles;
    while (rest.size() >= 3) {
        const std::size_t n = rest.size();
        std::size_t best = n;
        double best_shape = 0; // twice the area, divided by the square of the new edge's length
        for (std::size_t i = 0; i < n; ++i) {
            const PlanePoint &a = polygon[rest[(i + n - 1) % n]], &b = polygon[rest[i]],
                             &c = polygon[rest[(i + 1) % n]];
            const double edge = std::hypot(c[0] - a[0], c[1] - a[1]);
            const double shape = turn(a, b, c) / (edge * edge);
            if (shape <= best_shape) continue;
            const bool is_ear = std::none_of(rest.begin(), rest.end(), [&](int k) {
                const PlanePoint& p = polygon[k];
                return p != a && p != b && p != c && is_inside(p, a, b, c);
            });
            if (!is_ear) continue;
            best = i;
            best_shape = shape;
        }
        if (best == n) break; // not a simple polygon: check_mesh refuses the open mesh
        triangles.push_back({rest[(best + n - 1) % n], rest[best], rest[(best + 1) % n]});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return triangles;
}

} // namespace

TriangleMesh surface_of_revolution(const std::vector<PlanePoint>& profile, int sides)
{
    TriangleMesh mesh;
    std::vector<int> first; // for each point of the profile, the index of its first vertex
    for (const auto& [distance, height] : profile) {
        first.push_back(static_cast<int>(mesh.vertices.size()));
        for (int side = 0; side < (distance > 0 ? sides : 1); ++side) {
            const double angle = 2 * pi * side / sides;
            mesh.vertices.push_back(
                {distance * std::cos(angle), height, -distance * std::sin(angle)});
        }
    }
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const std::size_t j = (i + 1) % profile.size();
        const bool from_axis = !(profile[i][0] > 0), to_axis = !(profile[j][0] > 0);
        if (from_axis && to_axis) continue;
        for (int side = 0; side < sides; ++side) {
            const int next = (side + 1) % sides;
            const int a = first[i] + side, b = first[i] + next, c = first[j] + next,
                      d = first[j] + side;
            if (from_axis)
                mesh.triangles.push_back({first[i], c, d});
            else if (to_axis)
                mesh.triangles.push_back({a, b, first[j]});
            else
                add_quad(mesh, a, b, c, d);
        }
    }
    return mesh;
}

TriangleMesh extruded(const std::vector<PlanePoint>& outline, double thickness)
{
    const int n = static_cast<int>(outline.size());
    TriangleMesh mesh;
    for (const double side : {-0.5, 0.5})
        for (const auto& [x, y] : outline)
            mesh.vertices.push_back({x, y, side * thickness});
    for (const auto& [i, j, k] : triangulated(outline)) {
        mesh.triangles.push_back({k, j, i});
        mesh.triangles.push_back({n + i, n + j, n + k});
    }
    for (int i = 0; i < n; ++i)
        add_quad(mesh, i, (i + 1) % n, n + (i + 1) % n, n + i);
    return mesh;
}

TriangleMesh box_mesh(const Vector3d& size)
{
    const double x = size.x() / 2, y = size.y() / 2;
    return extruded({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, size.z());
}

TriangleMesh icosphere(double radius, int levels)
{
    const double t = std::numbers::phi;
    TriangleMesh mesh;
    mesh.vertices = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                     {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (Vector3d& v : mesh.vertices)
        v.normalize();
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int i, int j) {
            const auto [at, is_new] = middles.try_emplace({std::min(i, j), std::max(i, j)},
                                                          static_cast<int>(mesh.vertices.size()));
            if (is_new) mesh.vertices.push_back((mesh.vertices[i] + mesh.vertices[j]).normalized());
            return at->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [i, j, k] : mesh.triangles) {
            const int ij = middle(i, j), jk = middle(j, k), ki = middle(k, i);
            finer.insert(finer.end(), {{i, ij, ki}, {j, jk, ij}, {k, ki, jk}, {ij, jk, ki}});
        }
        mesh.triangles = std::move(finer);
    }
    for (Vector3d& v : mesh.vertices)
        v *= radius;
    return mesh;
}

TriangleMesh torus_mesh(double radius, double tube, int sides, int tube_sides)
{
    std::vector<PlanePoint> section;
    for (int i = 0; i < tube_sides; ++i) {
        const double angle = 2 * pi * i / tube_sides;
        section.push_back({radius + tube * std::cos(angle), tube * std::sin(angle)});
    }
    return surface_of_revolution(section, sides);
}

TriangleMesh ring_mesh(double inner_radius, double outer_radius, double height, int sides)
{
    const double y = height / 2;
    return surface_of_revolution(
        {{inner_radius, -y}, {outer_radius, -y}, {outer_radius, y}, {inner_radius, y}}, sides);
}

TriangleMesh cross_mesh(double length, double width)
{
    const double a = width / 2, b = length / 2;
    TriangleMesh mesh;
    // The corners of the cube in the middle. The bits of `corner` are the signs of x, y and z.
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices.push_back({corner & 1 ? a : -a, corner & 2 ? a : -a, corner & 4 ? a : -a});
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1}) {
            const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, w = side << axis;
            // The cube's corners where the bar begins, counter-clockwise seen from the bar's tip.
            std::array<int, 4> root = {w, w | u, w | u | v, w | v};
            if (side == 0) std::swap(root[1], root[3]);
            const int first = static_cast<int>(mesh.vertices.size());
            for (const int corner : root) {
                Vector3d tip = mesh.vertices[corner];
                tip[axis] = side ? b : -b;
                mesh.vertices.push_back(tip);
            }
            for (int i = 0; i < 4; ++i)
                add_quad(mesh, root[i], root[(i + 1) % 4], first + (i + 1) % 4, first + i);
            add_quad(mesh, first, first + 1, first + 2, first + 3);
        }
    return mesh;
}

TriangleMesh bowl_mesh(double radius, double thickness, int sides)
{
    const int steps = std::max(2, sides / 4);
    std::vector<PlanePoint> profile;
    const auto add_arc = [&](double r, int from, int to) {
        for (int i = from; i != to + (to > from ? 1 : -1); i += to > from ? 1 : -1) {
            const double angle = pi / 2 * i / steps; // measured from straight down
            const bool on_axis = i == 0, at_rim = i == steps;
            profile.push_back(
                {on_axis ? 0 : r * std::sin(angle), at_rim ? 0 : -r * std::cos(angle)});
        }
    };
    add_arc(radius, 0, steps);
    add_arc(radius - thickness, steps, 0);
    return surface_of_revolution(profile, sides);
}

TriangleMesh gear_mesh(int teeth, double radius, double bore, double thickness)
{
    const double pitch = 2 * pi / teeth, depth = radius * pitch / 2;
    // Depth of a root below the pitch circle and height of a tip above it, in units of `depth`.
    // Their difference is the clearance between a tip and the root of the other gear that it
    // passes.
    constexpr double dedendum = 0.6, addendum = 0.5;
    const double root = radius - dedendum * depth, tip = radius + addendum * depth;
    // Half the angle that a tooth spans at its root and at its tip, in units of `pitch`. Their mean
    // is below a quarter, so that a tooth is thinner than the gap of the other gear that it enters.
    constexpr double at_root = 0.33, at_tip = 0.15;
    std::vector<PlanePoint> outline; // angle [rad], distance from the axis [m]
    for (int tooth = 0; tooth < teeth; ++tooth)
        for (const auto& [angle, distance] : std::initializer_list<PlanePoint>{
                 {-at_root, root}, {-at_tip, tip}, {at_tip, tip}, {at_root, root}})
            outline.push_back({(tooth + angle) * pitch, distance});

    const int n = static_cast<int>(outline.size());
    TriangleMesh mesh;
    const auto add_vertices = [&](double y, bool is_outer) {
        for (const auto& [angle, distance] : outline) {
            const double r = is_outer ? distance : bore;
            mesh.vertices.push_back({r * std::cos(angle), y, -r * std::sin(angle)});
        }
    };
    const double y = thickness / 2;
    add_vertices(-y, true);
    add_vertices(y, true);
    if (bore > 0) {
        add_vertices(-y, false);
        add_vertices(y, false);
    } else {
        mesh.vertices.insert(mesh.vertices.end(), {{0, -y, 0}, {0, y, 0}});
    }
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        add_quad(mesh, i, j, n + j, n + i);
        if (bore > 0) {
            add_quad(mesh, 3 * n + i, 3 * n + j, 2 * n + j, 2 * n + i);
            add_quad(mesh, n + i, n + j, 3 * n + j, 3 * n + i);
            add_quad(mesh, 2 * n + i, 2 * n + j, j, i);
        } else {
            mesh.triangles.push_back({n + i, n + j, 2 * n + 1});
            mesh.triangles.push_back({2 * n, j, i});
        }
    }
    return mesh;
}

TriangleMesh angle_mesh(const Vector3d& size, double width)
{
    const double x = size.x() / 2, y = size.y() / 2;
    return extruded(
        {{-x, -y}, {x, -y}, {x, width - y}, {width - x, width - y}, {width - x, y}, {-x, y}},
        size.z());
}

TriangleMesh voussoir_mesh(double inner_radius, double outer_radius, double degrees,
                           double thickness)
{
    const double half = degrees * pi / 360;
    const double s = std::sin(half), c = std::cos(half);
    return extruded({{-inner_radius * s, inner_radius * c},
                     {inner_radius * s, inner_radius * c},
                     {outer_radius * s, outer_radius * c},
                     {-outer_radius * s, outer_radius * c}},
                    thickness);
}

} // namespace rigor
