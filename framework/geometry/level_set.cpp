// SPDX-License-Identifier: MIT
#include "geometry/level_set.hpp"

#include "geometry/bounding_tree.hpp"
#include "geometry/mesh_edges.hpp"
#include "geometry/triangle.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

BoundingTree tree_of(const TriangleMesh& mesh)
{
    std::vector<Bounds> boxes;
    boxes.reserve(mesh.triangles.size());
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
        boxes.push_back(triangle_of(mesh, t).bounds());
    return BoundingTree(boxes);
}

Bounds bounds_of(const TriangleMesh& mesh)
{
    Bounds bounds;
    for (const Vector3d& v : mesh.vertices)
        bounds.include({v, v});
    return bounds;
}

// The normals that decide on which side of the surface a point lies.
struct PseudoNormals {
    std::vector<Vector3d> faces, vertices;
    std::vector<std::array<Vector3d, 3>> edges; // ab, bc, ca of each triangle

    explicit PseudoNormals(const TriangleMesh& mesh)
        : faces(triangle_normals(mesh)), vertices(mesh.vertices.size(), Vector3d::Zero()),
          edges(mesh.triangles.size())
    {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (int i = 0; i < 3; ++i) {
                const auto& corners = mesh.triangles[t];
                const Vector3d& p = mesh.vertices[corners[i]];
                const Vector3d a = mesh.vertices[corners[(i + 1) % 3]] - p;
                const Vector3d b = mesh.vertices[corners[(i + 2) % 3]] - p;
                const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
                vertices[corners[i]] += angle * faces[t];
            }
        for (const MeshEdge& edge : mesh_edges(mesh, faces))
            for (const int t : {edge.left, edge.right})
                for (int i = 0; i < 3; ++i) {
                    const int from = mesh.triangles[t][i], to = mesh.triangles[t][(i + 1) % 3];
                    if (std::min(from, to) == edge.from && std::max(from, to) == edge.to)
                        edges[t][i] = faces[edge.left] + faces[edge.right];
                }
    }
};

// Nearest triangles, one query after the other, each near the last.
class Nearest {
public:
    explicit Nearest(const TriangleMesh& mesh) : mesh_(mesh), tree_(tree_of(mesh)), normals_(mesh)
    {
    }

    double signed_distance(const Vector3d& p)
    {
        p_ = p;
        nearest_ = nearest_on(triangle_of(mesh_, triangle_), p);
        squared_ = (nearest_.point - p).squaredNorm();
        descend(0);
        const int f = nearest_.feature;
        const Vector3d& n = f == 6  ? normals_.faces[triangle_]
                            : f < 3 ? normals_.vertices[mesh_.triangles[triangle_][f]]
                                    : normals_.edges[triangle_][f - 3];
        const double distance = std::sqrt(squared_);
        return n.dot(p - nearest_.point) < 0 ? -distance : distance;
    }

private:
    void descend(int index)
    {
        const BoundingTree::Node& node = tree_.nodes()[index];
        if (node.is_leaf()) {
            for (int i = node.first; i < node.last; ++i)
                visit(tree_.order()[i]);
            return;
        }
        int near = index + 1, far = node.right;
        double to_near = squared_distance(tree_.nodes()[near].bounds, p_);
        double to_far = squared_distance(tree_.nodes()[far].bounds, p_);
        if (to_far < to_near) {
            std::swap(near, far);
            std::swap(to_near, to_far);
        }
        if (to_near < squared_) descend(near);
        if (to_far < squared_) descend(far);
    }

    void visit(int triangle)
    {
        const NearestOnTriangle found = nearest_on(triangle_of(mesh_, triangle), p_);
        const double squared = (found.point - p_).squaredNorm();
        if (squared >= squared_) return;
        squared_ = squared;
        nearest_ = found;
        triangle_ = triangle;
    }

    const TriangleMesh& mesh_;
    BoundingTree tree_;
    PseudoNormals normals_;
    Vector3d p_ = Vector3d::Zero();
    int triangle_ = 0;
    NearestOnTriangle nearest_;
    double squared_ = 0;
};

// Where a line from a face's middle inwards comes out again [m]; infinite if it does not.
double thickness_at(const TriangleMesh& mesh, const BoundingTree& tree, int face)
{
    const Triangle triangle = triangle_of(mesh, face);
    const Vector3d start = (triangle.a + triangle.b + triangle.c) / 3;
    const Vector3d d = -triangle.area_normal().normalized();
    double nearest = std::numeric_limits<double>::infinity();
    const auto enter = [&](const Bounds& box) { // slabs
        double first = 0, last = nearest;
        for (int i = 0; i < 3; ++i) {
            double s = (box.low[i] - start[i]) / d[i], t = (box.high[i] - start[i]) / d[i];
            if (s > t) std::swap(s, t);
            if (s > first) first = s;
            if (t < last) last = t;
        }
        return first <= last;
    };
    tree.walk(enter, [&](int t) {
        const Triangle other = triangle_of(mesh, t);
        const Vector3d n = other.area_normal();
        const double towards = n.dot(d);
        if (t == face || towards <= 0) return; // seen from outside
        const double distance = n.dot(other.a - start) / towards;
        if (distance <= 0 || distance >= nearest) return;
        const Vector3d p = start + distance * d;
        if (nearest_on(other, p).feature == 6 ||
            (nearest_on(other, p).point - p).norm() < 1e-9 * distance)
            nearest = distance;
    });
    return nearest;
}

} // namespace

LevelSet make_level_set(const TriangleMesh& mesh, int cells)
{
    constexpr int margin = 2;
    const Bounds bounds = bounds_of(mesh);
    const Vector3d extent = bounds.high - bounds.low;
    LevelSet grid;
    const double h = grid.cell_size = extent.maxCoeff() / cells;
    Vector3d half;
    for (int i = 0; i < 3; ++i) {
        grid.size[i] = static_cast<int>(std::ceil(extent[i] / h - 1e-9)) + 1 + 2 * margin;
        half[i] = (grid.size[i] - 1) * h / 2;
    }
    grid.origin = (bounds.low + bounds.high) / 2 - half;
    const auto& [nx, ny, nz] = grid.size;
    grid.distances.reserve(static_cast<std::size_t>(nx) * ny * nz);
    Nearest nearest(mesh);
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                grid.distances.push_back(
                    nearest.signed_distance(grid.origin + h * Vector3d(i, j, k)));
    return grid;
}

int cells_for(const TriangleMesh& mesh)
{
    constexpr double least = 32, most = 64, across = 3, quantile = 0.1;
    const BoundingTree tree = tree_of(mesh);
    std::vector<std::pair<double, double>> walls; // thickness, area
    double area = 0;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        walls.push_back({thickness_at(mesh, tree, t), triangle_of(mesh, t).area_normal().norm()});
        area += walls.back().second;
    }
    std::sort(walls.begin(), walls.end());
    const Bounds bounds = bounds_of(mesh);
    const double longest = (bounds.high - bounds.low).maxCoeff();
    double seen = 0;
    for (const auto& [thickness, size] : walls) {
        seen += size;
        if (seen >= quantile * area)
            return static_cast<int>(
                std::clamp(std::ceil(across * longest / thickness), least, most));
    }
    return static_cast<int>(least);
}

} // namespace rigor
