// SPDX-License-Identifier: MIT
// Samples the surface of a mesh for contacts. Each sample has the cone of the normals along which
// the surface can be touched there (normal cones: Rockafellar 1970, "Convex analysis"). Vertices
// come first, then convex edges, then faces in rows. In a round hole, a body touches the middle of
// facets and not their vertices, which lie farther out; there even short edges and small faces get
// a point in their middle.
#include "geometry/meshes/mesh_surface.hpp"

#include "geometry/meshes/mesh_edges.hpp"
#include "geometry/meshes/triangle.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// Sine of about ten degrees. Edges that bend less are not tested for contacts edge against edge:
// the facets of a round surface meet in such edges.
constexpr double sharp = 0.17;

// Unit vectors count as equal if the length of their difference is below this. The angle between
// them counts as acute if their dot product is above this. The value is far above the rounding of
// normals and, in radians, far below the angle of any edge that matters.
constexpr double same = 1e-6;

// A triangle is a sliver if its height is below this fraction of its longest side. It gets no point
// in its middle, which would lie almost on the sides, where rounding makes distances inaccurate.
constexpr double sliver = 0.05;

// Whether a flat face of another body, with the normal -n, can touch the surface at one of these
// vertices. If so, the edge or face between these vertices needs no sample point in its middle.
bool is_touched_at(const MeshSurface& surface, std::initializer_list<int> vertices,
                   const Vector3d& n)
{
    return std::any_of(vertices.begin(), vertices.end(), [&](int v) {
        return surface.nearest_normal(surface.points()[v].cone, n).dot(n) > 1 - same;
    });
}

} // namespace

MeshSurface::MeshSurface(const TriangleMesh& mesh, double spacing) : spacing_(spacing)
{
    const std::vector<Vector3d> normals = triangle_normals(mesh);
    add_vertices(mesh, normals);
    add_edges(mesh, normals);
    add_faces(mesh, normals);

    std::vector<Bounds> boxes;
    for (const SurfacePoint& p : points_)
        boxes.push_back({p.point, p.point});
    point_tree_ = BoundingTree(boxes);
    boxes.clear();
    for (const SharpEdge& e : edges_)
        boxes.push_back({e.from.cwiseMin(e.to), e.from.cwiseMax(e.to)});
    edge_tree_ = BoundingTree(boxes);
}

int MeshSurface::add_cone(const std::vector<Vector3d>& normals,
                          const std::vector<Vector3d>& directions)
{
    Cone cone;
    cone.first_normal = static_cast<int>(cone_normals_.size());
    cone.first_direction = static_cast<int>(cone_directions_.size());
    for (const Vector3d& n : normals) // the equal normals of a flat face are stored once
        if (std::none_of(cone_normals_.begin() + cone.first_normal, cone_normals_.end(),
                         [&](const Vector3d& known) { return (known - n).norm() < same; }))
            cone_normals_.push_back(n);
    cone_directions_.insert(cone_directions_.end(), directions.begin(), directions.end());
    cone.last_normal = static_cast<int>(cone_normals_.size());
    cone.last_direction = static_cast<int>(cone_directions_.size());
    cones_.push_back(cone);
    return static_cast<int>(cones_.size()) - 1;
}

void MeshSurface::add_vertices(const TriangleMesh& mesh, const std::vector<Vector3d>& normals)
{
    std::vector<std::vector<Vector3d>> faces(mesh.vertices.size()),
        directions(mesh.vertices.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const int v = mesh.triangles[t][i], w = mesh.triangles[t][(i + 1) % 3];
            faces[v].push_back(normals[t]);
            directions[v].push_back((mesh.vertices[w] - mesh.vertices[v]).normalized());
        }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        points_.push_back({mesh.vertices[v], add_cone(faces[v], directions[v])});
}

void MeshSurface::add_edges(const TriangleMesh& mesh, const std::vector<Vector3d>& normals)
{
    for (const MeshEdge& edge : mesh_edges(mesh, normals)) {
        const Vector3d &from = mesh.vertices[edge.from], &to = mesh.vertices[edge.to];
        const Vector3d &n1 = normals[edge.left], &n2 = normals[edge.right];
        const bool is_convex = edge.bend > same;
        if (!is_convex) continue;
        const Vector3d along = (to - from).normalized();
        // Directions in the faces, away from the edge.
        const Vector3d into1 = n1.cross(along), into2 = along.cross(n2);
        const int cone = add_cone({n1, n2}, {along, -along, into1, into2});
        // A thin wedge bends by almost 180 degrees, where the sine is small again.
        if (edge.bend > sharp || n1.dot(n2) < 0) edges_.push_back({from, to, n1, n2, cone});
        const bool ends_touch = is_touched_at(*this, {edge.from, edge.to}, n1) &&
                                is_touched_at(*this, {edge.from, edge.to}, n2);
        const int pieces = std::max(static_cast<int>(std::ceil((to - from).norm() / spacing_)),
                                    ends_touch ? 1 : 2);
        for (int i = 1; i < pieces; ++i)
            points_.push_back({from + static_cast<double>(i) / pieces * (to - from), cone});
    }
}

// Adds points on each face, in rows parallel to its longest side. Rows are at most 2 `spacing_`
// apart, and so are the points in a row.
void MeshSurface::add_faces(const TriangleMesh& mesh, const std::vector<Vector3d>& normals)
{
    const double spacing = 2 * spacing_;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        Triangle triangle = triangle_of(mesh, t);
        for (int turns = 0; turns < 2; ++turns) // until ab is the longest side
            if ((triangle.b - triangle.a).norm() <
                std::max((triangle.c - triangle.b).norm(), (triangle.a - triangle.c).norm()))
                triangle = {triangle.b, triangle.c, triangle.a};
        const Vector3d base = triangle.b - triangle.a;
        const double height = 2 * triangle.area_normal().norm() / base.norm();
        const int rows = static_cast<int>(std::ceil(height / spacing));
        int cone = -1;
        for (int row = 1; row < rows; ++row) {
            const double up = static_cast<double>(row) / rows;
            const Vector3d start = triangle.a + up * (triangle.c - triangle.a);
            const Vector3d line = (1 - up) * base;
            const int pieces = static_cast<int>(std::ceil(line.norm() / spacing));
            for (int i = 1; i < pieces; ++i) {
                if (cone < 0) cone = add_cone({normals[t]}, {});
                points_.push_back({start + static_cast<double>(i) / pieces * line, cone});
            }
        }
        const auto& [a, b, c] = mesh.triangles[t];
        const bool is_sliver = height < sliver * base.norm();
        if (cone < 0 && !is_sliver && !is_touched_at(*this, {a, b, c}, normals[t]))
            points_.push_back(
                {(triangle.a + triangle.b + triangle.c) / 3, add_cone({normals[t]}, {})});
    }
}

bool MeshSurface::touches(const Cone& cone, const Vector3d& d) const
{
    for (int i = cone.first_direction; i < cone.last_direction; ++i)
        if (cone_directions_[i].dot(d) > same) return false;
    return true;
}

Vector3d MeshSurface::nearest_normal(int index, const Vector3d& d) const
{
    const Cone& cone = cones_[index];
    if (cone.last_normal - cone.first_normal == 1) return cone_normals_[cone.first_normal];
    if (touches(cone, d)) return d;
    Vector3d best = d;
    double nearest = -2;
    const auto consider = [&](const Vector3d& n) {
        if (n.dot(d) <= nearest || !touches(cone, n)) return;
        nearest = n.dot(d);
        best = n;
    };
    for (int i = cone.first_normal; i < cone.last_normal; ++i)
        consider(cone_normals_[i]);
    // Directions between two face normals: d, projected on the plane perpendicular to an edge.
    for (int i = cone.first_direction; i < cone.last_direction; ++i) {
        const Vector3d& along = cone_directions_[i];
        const Vector3d across = d - along.dot(d) * along;
        if (across.norm() > same) consider(across.normalized());
    }
    return best;
}

} // namespace rigor
