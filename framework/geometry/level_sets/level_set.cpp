// SPDX-License-Identifier: MIT
// Computes the signed distance to a mesh at every node of a grid. The sign comes from
// angle-weighted pseudonormals (Baerentzen and Aanaes 2005, "Signed distance computation using the
// angle weighted pseudonormal"). Nodes are visited row by row, because the triangle nearest to one
// node is a good start for the search from the next. To suggest a number of cells, rays measure the
// thickness of the mesh's walls.
#include "geometry/level_sets/level_set.hpp"

#include "geometry/meshes/mesh_edges.hpp"
#include "geometry/meshes/triangle_tree.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// Pseudonormals: the normal of a face, at an edge the sum of the normals of its two faces, and at a
// vertex the sum of the normals of its faces, each weighted by the face's angle there.
struct PseudoNormals {
    std::vector<Vector3d> faces, vertices;
    std::vector<std::array<Vector3d, 3>> edges; // for each triangle, at its edges ab, bc, ca

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

// Signed distances of points. The search is fast if each point is near the one before.
class SignedDistance {
public:
    explicit SignedDistance(const TriangleMesh& mesh) : mesh_(mesh), tree_(mesh), normals_(mesh) {}

    double at(const Vector3d& p)
    {
        const TriangleTree::Found nearest = tree_.nearest(p, last_);
        const int t = last_ = nearest.triangle, f = nearest.feature;
        const Vector3d& n = f == 6  ? normals_.faces[t]
                            : f < 3 ? normals_.vertices[mesh_.triangles[t][f]]
                                    : normals_.edges[t][f - 3];
        const double distance = std::sqrt(nearest.squared_distance);
        return n.dot(p - nearest.point) < 0 ? -distance : distance;
    }

private:
    const TriangleMesh& mesh_;
    TriangleTree tree_;
    PseudoNormals normals_;
    int last_ = 0; // index of the triangle nearest to the previous point
};

// A ray counts as hitting a triangle if it passes beside the triangle by less than this times the
// distance along the ray. Such a gap is a rounding error: a ray through an edge must not slip
// between two triangles.
constexpr double on_edge = 1e-9;

// The length of a ray from a face's middle, along the inward normal, to the opposite side of the
// mesh [m]; infinite if the ray hits nothing.
double thickness_at(const TriangleMesh& mesh, const TriangleTree& tree, int face)
{
    const Triangle triangle = triangle_of(mesh, face);
    const Vector3d start = (triangle.a + triangle.b + triangle.c) / 3;
    const Vector3d d = -triangle.area_normal().normalized();
    double nearest = std::numeric_limits<double>::infinity();
    const auto enter = [&](const Bounds& box) { // the slab test of a ray against a box
        double first = 0, last = nearest;
        for (int i = 0; i < 3; ++i) {
            double s = (box.low[i] - start[i]) / d[i], t = (box.high[i] - start[i]) / d[i];
            if (s > t) std::swap(s, t);
            if (s > first) first = s;
            if (t < last) last = t;
        }
        return first <= last;
    };
    tree.tree().walk(enter, [&](int t) {
        const Triangle other = triangle_of(mesh, t);
        const Vector3d n = other.area_normal();
        const double towards = n.dot(d);
        if (t == face || towards <= 0) return; // the ray would enter the solid here
        const double distance = n.dot(other.a - start) / towards;
        if (distance <= 0 || distance >= nearest) return;
        const Vector3d p = start + distance * d;
        if (nearest_on(other, p).feature == 6 ||
            (nearest_on(other, p).point - p).norm() < on_edge * distance)
            nearest = distance;
    });
    return nearest;
}

} // namespace

LevelSet make_level_set(const TriangleMesh& mesh, int cells)
{
    constexpr int margin = 2; // cells beyond the mesh's bounds on each side
    // A rounding error of the extent must not add a layer of cells, so their number is rounded up
    // only if it exceeds a whole number by more than this.
    constexpr double rounding = 1e-9;
    const Bounds bounds = bounds_of(mesh);
    const Vector3d extent = bounds.high - bounds.low;
    LevelSet grid;
    const double h = grid.cell_size = extent.maxCoeff() / cells;
    Vector3d half;
    for (int i = 0; i < 3; ++i) {
        grid.size[i] = static_cast<int>(std::ceil(extent[i] / h - rounding)) + 1 + 2 * margin;
        half[i] = (grid.size[i] - 1) * h / 2;
    }
    grid.origin = (bounds.low + bounds.high) / 2 - half;
    const auto& [nx, ny, nz] = grid.size;
    grid.distances.reserve(static_cast<std::size_t>(nx) * ny * nz);
    SignedDistance distance(mesh);
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                grid.distances.push_back(distance.at(grid.origin + h * Vector3d(i, j, k)));
    return grid;
}

int suggested_cells(const TriangleMesh& mesh)
{
    // Cells along the longest side: fewer lose detail, more take time and memory.
    constexpr double least = 32, most = 64;
    // Cells across a wall. With fewer, interpolation would mix the distances of its two sides.
    constexpr double across = 3;
    // Share of the surface area whose walls may have fewer than `across` cells, so that a thin rim
    // does not decide the number of cells.
    constexpr double quantile = 0.1;
    const TriangleTree tree(mesh);
    std::vector<std::pair<double, double>> walls; // at each face: thickness [m], area [m²]
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
