// SPDX-License-Identifier: MIT
// The surface of a shape as triangles to draw. Round shapes are meshed as surfaces of revolution
// with 64 sides. An edge whose two triangles have normals that differ by more than 30 degrees is
// sharp and gets a line. The normal at a corner of a triangle is the mean of the normals of all
// triangles there that differ from the triangle's own normal by less than 30 degrees, weighted by
// their angles at the corner.
#include "render/shape_surfaces.hpp"

#include "geometry/meshes/generators.hpp"
#include "geometry/meshes/mesh_edges.hpp"
#include "geometry/shapes/solid_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {
namespace {

constexpr int sides = 64; // sides of the polygon that approximates a circle

struct MeshOf {
    TriangleMesh operator()(const Capsule& c) const
    {
        constexpr int steps = 16;
        std::vector<PlanePoint> profile;
        for (int half = 0; half < 2; ++half)
            for (int i = 0; i <= steps; ++i) {
                const double angle = std::numbers::pi / 2 * (i + half * steps) / steps;
                const bool on_axis = half == 0 ? i == 0 : i == steps;
                profile.push_back({on_axis ? 0 : c.radius * std::sin(angle),
                                   (half - 0.5) * c.height - c.radius * std::cos(angle)});
            }
        return surface_of_revolution(profile, sides);
    }
    TriangleMesh operator()(const Torus& t) const
    {
        return torus_mesh(t.radius, t.tube, sides, sides / 2);
    }
    TriangleMesh operator()(const Cylinder& c) const
    {
        const double y = c.height / 2;
        return surface_of_revolution({{0, -y}, {c.radius, -y}, {c.radius, y}, {0, y}}, sides);
    }
    TriangleMesh operator()(const Cone& c) const
    {
        const double y = -0.25 * c.height;
        return surface_of_revolution({{0, y}, {c.radius, y}, {0, 0.75 * c.height}}, sides);
    }
    TriangleMesh operator()(const Mesh& m) const { return m.solid->mesh(); }
    template <class Other> TriangleMesh operator()(const Other&) const { return {}; }
};

// The normal for shading, at a corner of a triangle. It is the mean of the normals of the triangles
// at this vertex, weighted by their angles there. Normals that differ by more than 30 degrees from
// the triangle's own are left out, so that edges look sharp.
class CornerNormals {
public:
    CornerNormals(const TriangleMesh& mesh, const std::vector<Vector3d>& normals)
        : mesh_(mesh), normals_(normals), around_(mesh.vertices.size())
    {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (const int v : mesh.triangles[t])
                around_[v].push_back(static_cast<int>(t));
    }

    Vector3d at(int triangle, int vertex) const
    {
        Vector3d sum = Vector3d::Zero();
        for (const int t : around_[vertex])
            if (normals_[t].dot(normals_[triangle]) > smooth) sum += angle(t, vertex) * normals_[t];
        return sum.normalized();
    }

private:
    double angle(int triangle, int vertex) const
    {
        const auto& corners = mesh_.triangles[triangle];
        const auto at = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
        const Vector3d& p = mesh_.vertices[vertex];
        const Vector3d a = mesh_.vertices[corners[(at + 1) % 3]] - p;
        const Vector3d b = mesh_.vertices[corners[(at + 2) % 3]] - p;
        return std::atan2(a.cross(b).norm(), a.dot(b));
    }

    const TriangleMesh& mesh_;
    const std::vector<Vector3d>& normals_;
    std::vector<std::vector<int>> around_; // for each vertex, its triangles
};

// For each triangle, whether its edges from corner 0 to 1, from 1 to 2 and from 2 to 0 are sharp.
std::vector<std::array<bool, 3>> sharp_edges(const TriangleMesh& mesh,
                                             const std::vector<Vector3d>& normals)
{
    std::vector<std::array<bool, 3>> sharp(mesh.triangles.size(), {false, false, false});
    for (const MeshEdge& edge : mesh_edges(mesh, normals)) {
        if (normals[edge.left].dot(normals[edge.right]) > smooth) continue;
        for (const int t : {edge.left, edge.right})
            for (int i = 0; i < 3; ++i) {
                const int a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
                if (std::min(a, b) == edge.from && std::max(a, b) == edge.to) sharp[t][i] = true;
            }
    }
    return sharp;
}

// The contrast between the two tones of the octants (see `Surface`). It is strong for round shapes,
// where nothing else shows that they rotate, weak for a mesh with round parts, and 0 for a mesh
// whose rotation the edges show.
float contrast(const Shape& shape, const TriangleMesh& mesh, const std::vector<Vector3d>& normals)
{
    if (!std::holds_alternative<Mesh>(shape)) return 0.7F;
    const auto edges = mesh_edges(mesh, normals);
    const bool is_round = std::any_of(edges.begin(), edges.end(), [&](const MeshEdge& edge) {
        const double c = normals[edge.left].dot(normals[edge.right]);
        // The two normals differ by more than about one degree, but the edge is not sharp.
        return c > smooth && c < 0.9998;
    });
    return is_round ? 0.3F : 0.0F;
}

} // namespace

Surface surface_of(const Shape& shape)
{
    const TriangleMesh mesh = std::visit(MeshOf{}, shape);
    const std::vector<Vector3d> normals = triangle_normals(mesh);
    const CornerNormals corner_normals(mesh, normals);
    const auto sharp = sharp_edges(mesh, normals);
    Bounds bounds;
    for (const Vector3d& v : mesh.vertices)
        bounds.include({v, v});
    const Vector3d center = (bounds.low + bounds.high) / 2;

    Surface surface;
    surface.contrast = contrast(shape, mesh, normals);
    surface.center = center.cast<float>();
    surface.triangles.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const int v = mesh.triangles[t][i];
            const Vector3d p = mesh.vertices[v];
            const Vector3d next = mesh.vertices[mesh.triangles[t][(i + 1) % 3]];
            const Vector3d last = mesh.vertices[mesh.triangles[t][(i + 2) % 3]];
            SurfaceVertex vertex{(p - center).cast<float>(),
                                 corner_normals.at(static_cast<int>(t), v).cast<float>()};
            const double height = (next - p).cross(last - p).norm() / (last - next).norm();
            // The distance from corner i is 0 to two sides and the height to the third.
            for (int edge = 0; edge < 3; ++edge)
                if (sharp[t][edge])
                    vertex.edges[edge] = edge == (i + 1) % 3 ? static_cast<float>(height) : 0.0F;
            surface.radius = std::max(surface.radius, vertex.position.norm());
            surface.triangles.push_back(vertex);
        }
    return surface;
}

} // namespace rigor
