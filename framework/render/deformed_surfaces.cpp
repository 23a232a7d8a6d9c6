// SPDX-License-Identifier: MIT
// The surface of a deforming solid as triangles to draw. The points of the surface are embedded in
// the tetrahedra and move with their nodes. An edge is sharp if the normals of its two triangles
// differ by more than 30 degrees, or if only one of them was opened by a crack. The normal at a
// corner of a triangle is the mean of the normals of all triangles at this corner, weighted by
// their angles there. Triangles whose common edge with this triangle is or would be sharp are left
// out.
#include "render/deformed_surfaces.hpp"

#include "deformable/surface/surface.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace rigor {
namespace {

// The surface of a solid at one moment.
class DeformedSurface {
public:
    explicit DeformedSurface(const SolidFrame& solid);

    DeformedVertex vertex(int triangle, int corner) const;

private:
    struct Edge {
        int from, to, triangle, side; // from < to
    };
    void find_edges();
    void add_line(const Edge& edge, const Edge& other_side);
    bool is_sharp(int triangle1, int triangle2) const;
    double angle(int triangle, int corner) const;
    Vector3d normal(int triangle, int corner) const;
    const Vector3d* line_through(int triangle, int corner) const;
    const Vector3d& place(int triangle, int corner) const
    {
        return places_[triangles_[triangle].points[corner % 3]];
    }

    const std::vector<EmbeddedTriangle>& triangles_;
    std::vector<Vector3d> places_;             // for each point, its position [m]
    std::vector<Vector3d> normals_;            // for each triangle, its unit normal
    std::vector<std::vector<Vector3d>> lines_; // for each point, unit vectors along its sharp edges
    std::vector<std::array<bool, 3>> sharp_; // for each triangle: whether its three sides are sharp
    // All corners of triangles, as 3 * triangle + corner, sorted by their points; and for each
    // point, the index in `corners_` at which its corners begin.
    std::vector<int> corners_, first_corner_;
};

DeformedSurface::DeformedSurface(const SolidFrame& solid)
    : triangles_(solid.topology->surface.triangles)
{
    const SolidTopology& topology = *solid.topology;
    for (const EmbeddedPoint& point : topology.surface.points) {
        Vector3d& x = places_.emplace_back(Vector3d::Zero());
        for (int i = 0; i < 4; ++i)
            x += point.weights[i] * solid.positions[topology.elements[point.element][i]];
    }
    first_corner_.assign(places_.size() + 1, 0);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        const int n = static_cast<int>(t);
        const Vector3d across = (place(n, 1) - place(n, 0)).cross(place(n, 2) - place(n, 0));
        normals_.push_back(across.norm() > 0 ? Vector3d(across.normalized()) : Vector3d::UnitY());
        for (const int point : triangles_[t].points)
            ++first_corner_[point + 1];
    }
    for (std::size_t i = 1; i < first_corner_.size(); ++i)
        first_corner_[i] += first_corner_[i - 1];
    corners_.resize(3 * triangles_.size());
    std::vector<int> next = first_corner_;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        for (int i = 0; i < 3; ++i)
            corners_[next[triangles_[t].points[i]]++] = static_cast<int>(3 * t) + i;
    find_edges();
}

bool DeformedSurface::is_sharp(int triangle1, int triangle2) const
{
    return triangles_[triangle1].is_crack != triangles_[triangle2].is_crack ||
           !(normals_[triangle1].dot(normals_[triangle2]) > smooth);
}

// Finds the sharp edges. Only an edge of exactly two triangles is drawn.
void DeformedSurface::find_edges()
{
    std::vector<Edge> edges;
    edges.reserve(3 * triangles_.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        for (int side = 0; side < 3; ++side) {
            const int a = triangles_[t].points[side], b = triangles_[t].points[(side + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), side});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.from, a.to, a.triangle, a.side) <
               std::tie(b.from, b.to, b.triangle, b.side);
    });
    sharp_.assign(triangles_.size(), {false, false, false});
    lines_.resize(places_.size());
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && edges[end].from == edges[i].from &&
               edges[end].to == edges[i].to)
            ++end;
        if (end - i == 2 && is_sharp(edges[i].triangle, edges[i + 1].triangle))
            add_line(edges[i], edges[i + 1]);
        i = end;
    }
}

void DeformedSurface::add_line(const Edge& edge, const Edge& other_side)
{
    sharp_[edge.triangle][edge.side] = sharp_[other_side.triangle][other_side.side] = true;
    const Vector3d along = (places_[edge.to] - places_[edge.from]).normalized();
    for (const int point : {edge.from, edge.to})
        lines_[point].push_back(along);
}

// Looks for a sharp edge of other triangles that lies within 30 degrees of the plane of this
// triangle and touches this triangle only in this corner. Such an edge is drawn on this triangle
// too, since the line along the edge would have gaps otherwise.
// @return the direction of the edge; nullptr if there is none
const Vector3d* DeformedSurface::line_through(int triangle, int corner) const
{
    if (sharp_[triangle][corner] || sharp_[triangle][(corner + 2) % 3]) return nullptr;
    const Vector3d& p = place(triangle, corner);
    const Vector3d a = place(triangle, corner + 1) - p, b = place(triangle, corner + 2) - p;
    for (const Vector3d& along : lines_[triangles_[triangle].points[corner]]) {
        if (!(std::abs(along.dot(normals_[triangle])) < 0.5)) continue;
        // Only a triangle that lies wholly on one side of the straight line through the edge gets
        // the line. A triangle beyond the end of the edge is cut by this straight line, or has a
        // side on it.
        const Vector3d across = normals_[triangle].cross(along);
        const double side_a = across.dot(a) / a.norm(), side_b = across.dot(b) / b.norm();
        if (side_a * side_b > 0 && std::min(std::abs(side_a), std::abs(side_b)) > 0.1)
            return &along;
    }
    return nullptr;
}

double DeformedSurface::angle(int triangle, int corner) const
{
    const Vector3d& p = place(triangle, corner);
    const Vector3d a = place(triangle, corner + 1) - p, b = place(triangle, corner + 2) - p;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// The mean of the normals of all triangles around the corner, weighted by their angles there.
// Triangles whose common edge with this triangle is or would be sharp (`is_sharp`) are left out.
Vector3d DeformedSurface::normal(int triangle, int corner) const
{
    const int point = triangles_[triangle].points[corner];
    Vector3d sum = Vector3d::Zero();
    for (int i = first_corner_[point]; i < first_corner_[point + 1]; ++i) {
        const int other = corners_[i] / 3;
        if (!is_sharp(other, triangle)) sum += angle(other, corners_[i] % 3) * normals_[other];
    }
    return sum.norm() > 0 ? Vector3d(sum.normalized()) : normals_[triangle];
}

DeformedVertex DeformedSurface::vertex(int triangle, int corner) const
{
    const Vector3d &p = place(triangle, corner), &next = place(triangle, corner + 1),
                   &last = place(triangle, corner + 2);
    DeformedVertex vertex{p.cast<float>(), normal(triangle, corner).cast<float>()};
    const double base = (last - next).norm();
    const double height = base > 0 ? (next - p).cross(last - p).norm() / base : 0;
    for (int side = 0; side < 3; ++side) // the distance is 0 to the two sides at the corner
        if (sharp_[triangle][side])
            vertex.edges[side] = side == (corner + 1) % 3 ? static_cast<float>(height) : 0.0F;
    // The line of an edge that touches the triangle only in corner `at` is stored in place of the
    // opposite side, if that side is not sharp.
    for (int at = 0; at < 3; ++at) {
        const int side = (at + 1) % 3;
        const Vector3d* along = sharp_[triangle][side] ? nullptr : line_through(triangle, at);
        if (along)
            vertex.edges[side] = static_cast<float>((p - place(triangle, at)).cross(*along).norm());
    }
    return vertex;
}

} // namespace

void add_deformed_surface(std::vector<DeformedVertex>& vertices, const SolidFrame& solid,
                          const std::function<Vector4f(const EmbeddedTriangle&, int point)>& color)
{
    const DeformedSurface surface(solid);
    const std::vector<EmbeddedTriangle>& triangles = solid.topology->surface.triangles;
    vertices.reserve(vertices.size() + 3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int corner = 0; corner < 3; ++corner) {
            vertices.push_back(surface.vertex(static_cast<int>(t), corner));
            vertices.back().color = color(triangles[t], triangles[t].points[corner]);
        }
}

std::vector<float> at_points(const SolidTopology& topology, const std::vector<float>& of_elements)
{
    std::vector<float> sum(topology.nodes, 0), count(topology.nodes, 0);
    for (std::size_t e = 0; e < topology.elements.size(); ++e)
        for (const int node : topology.elements[e]) {
            sum[node] += of_elements[e];
            count[node] += 1;
        }
    std::vector<float> values;
    values.reserve(topology.surface.points.size());
    for (const EmbeddedPoint& point : topology.surface.points) {
        double value = 0;
        for (int i = 0; i < 4; ++i) {
            const int node = topology.elements[point.element][i];
            value += point.weights[i] * sum[node] / count[node];
        }
        values.push_back(static_cast<float>(value));
    }
    return values;
}

} // namespace rigor
