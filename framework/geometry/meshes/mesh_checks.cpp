// SPDX-License-Identifier: MIT
// Checks that a triangle mesh is the surface of a solid. Edges are matched as half-edges, and
// intersections are found with a bounding tree. Whether a piece lies inside another is found by
// winding numbers, which are computed from solid angles (van Oosterom and Strackee 1983, "The solid
// angle of a plane triangle"). Each check relies on the checks before it.
#include "geometry/meshes/mesh_checks.hpp"

#include "geometry/meshes/mesh_edges.hpp"
#include "geometry/meshes/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

// A face has no area if its area, divided by the square of its longest edge, is at most this: such
// an area is a rounding error.
constexpr double least_area = 1e-12;

// A mesh has no volume if its volume, divided by the cube of the longest side of its bounds, is at
// most this: such a volume is a rounding error. The same number, times the cube of the length of
// the edge or of the face's bounds, whichever is longer, is the tolerance of `pierces`.
constexpr double least_volume = 1e-12;

// Two unit normals count as opposite if the length of their sum is below this.
constexpr double folded = 1e-9;

// The allowed error of a winding number: 1/2 is expected at a point on a face.
constexpr double winding_tolerance = 0.01;

// The largest number of closed pieces of a surface. It limits the time of the check, because a
// point of each piece is compared with all faces.
constexpr std::size_t most_pieces = 64;

class Check {
public:
    Check(const TriangleMesh& mesh, const std::vector<int>& lines)
        : mesh_(mesh), lines_(lines), bounds_(bounds())
    {
    }

    void run()
    {
        check_numbers();
        check_areas();
        const std::vector<HalfEdge> edges = sorted_half_edges(mesh_);
        check_closed(edges);
        check_outward();
        check_folds(edges);
        check_crossings();
        check_pieces(edges);
    }

private:
    int line(int triangle) const { return lines_.empty() ? 0 : lines_[triangle]; }

    std::string place(int vertex) const
    {
        const Vector3d& v = mesh_.vertices[vertex];
        return "(" + number_text(v.x()) + ", " + number_text(v.y()) + ", " + number_text(v.z()) +
               ")";
    }
    std::string place(const HalfEdge& e) const
    {
        return "from " + place(e.low) + " to " + place(e.high);
    }
    // The name of a face in an error message.
    std::string face(int triangle) const
    {
        return lines_.empty() ? "face " + std::to_string(triangle + 1)
                              : "the face of line " + std::to_string(lines_[triangle]);
    }

    Bounds bounds() const
    {
        Bounds all;
        for (const Vector3d& v : mesh_.vertices)
            if (v.allFinite()) all.include({v, v});
        return all;
    }

    void check_numbers() const
    {
        const int count = static_cast<int>(mesh_.vertices.size());
        if (mesh_.triangles.empty()) throw MeshError(0, "expected a mesh with faces, found none");
        if (mesh_.triangles.size() > most_mesh_triangles)
            throw MeshError(0, "expected at most " + std::to_string(most_mesh_triangles) +
                                   " triangles, found " + std::to_string(mesh_.triangles.size()));
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
            for (const int vertex : mesh_.triangles[t]) {
                const int at = line(static_cast<int>(t));
                if (vertex < 0 || vertex >= count)
                    throw MeshError(at, "expected vertices from 1 to " + std::to_string(count) +
                                            ", found " + std::to_string(vertex + 1));
                if (!mesh_.vertices[vertex].allFinite())
                    throw MeshError(at, "expected finite vertices, found one at " + place(vertex));
            }
    }

    void check_areas() const
    {
        for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
            const Triangle triangle = triangle_of(mesh_, t);
            const double longest = std::max({(triangle.b - triangle.a).squaredNorm(),
                                             (triangle.c - triangle.b).squaredNorm(),
                                             (triangle.a - triangle.c).squaredNorm()});
            if (!(triangle.area_normal().norm() > least_area * longest))
                throw MeshError(line(t), "expected a face with an area, found none at " +
                                             place(mesh_.triangles[t][0]));
        }
    }

    void check_closed(const std::vector<HalfEdge>& edges) const
    {
        for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
            while (last < edges.size() && edges[last].same_edge(edges[first]))
                ++last;
            const HalfEdge& e = edges[first];
            if (last - first == 1)
                throw MeshError(line(e.triangle), "expected a closed surface, found the edge " +
                                                      place(e) + " in one face only");
            if (last - first > 2)
                throw MeshError(line(e.triangle), "expected two faces at each edge, found " +
                                                      std::to_string(last - first) +
                                                      " at the one " + place(e));
            if (e.is_upward == edges[first + 1].is_upward)
                throw MeshError(line(edges[first + 1].triangle),
                                "expected a consistent winding, found the edge " + place(e) +
                                    " traversed twice in one direction: flip " +
                                    face(edges[first + 1].triangle) + " or " + face(e.triangle));
        }
    }

    void check_outward() const
    {
        const double volume = signed_volume(mesh_);
        const double rounding = least_volume * std::pow((bounds_.high - bounds_.low).maxCoeff(), 3);
        if (std::abs(volume) <= rounding)
            throw MeshError(0, "expected a mesh with a volume, found none");
        if (volume < 0)
            throw MeshError(0,
                            "expected faces that turn counter-clockwise seen from outside, found "
                            "a volume of " +
                                number_text(volume) + " m³: flip all faces");
    }

    // Refuses two faces at an edge that are folded onto each other: their normals are opposite.
    void check_folds(const std::vector<HalfEdge>& edges) const
    {
        for (std::size_t i = 0; i < edges.size(); i += 2) {
            const int t = edges[i].triangle, u = edges[i + 1].triangle;
            const Vector3d n = triangle_of(mesh_, t).area_normal().normalized();
            const Vector3d m = triangle_of(mesh_, u).area_normal().normalized();
            if ((n + m).norm() < folded) refuse_crossing(t, u);
        }
    }

    [[noreturn]] void refuse_crossing(int t, int u) const
    {
        throw MeshError(line(u), "expected a surface that does not go through itself, found " +
                                     face(u) + " crossing " + face(t));
    }

    bool share(int t, int u, int vertices) const
    {
        int shared = 0;
        for (const int i : mesh_.triangles[t])
            for (const int j : mesh_.triangles[u])
                shared += i == j;
        return shared >= vertices;
    }

    // Whether an edge of triangle t goes through triangle u. Edges that share a vertex with u are
    // left out.
    bool edge_through(int t, int u) const
    {
        const Triangle triangle = triangle_of(mesh_, u);
        const auto& corners = mesh_.triangles[u];
        const auto is_corner = [&](int vertex) {
            return std::find(corners.begin(), corners.end(), vertex) != corners.end();
        };
        const double size = (triangle.bounds().high - triangle.bounds().low).maxCoeff();
        for (int i = 0; i < 3; ++i) {
            const int from = mesh_.triangles[t][i], to = mesh_.triangles[t][(i + 1) % 3];
            if (is_corner(from) || is_corner(to)) continue;
            const Vector3d &p = mesh_.vertices[from], &q = mesh_.vertices[to];
            const double length = std::max(size, (q - p).norm());
            if (pierces(p, q, triangle, least_volume * length * length * length)) return true;
        }
        return false;
    }

    void check_crossings() const
    {
        const TriangleTree tree(mesh_);
        for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
            const Bounds box = triangle_of(mesh_, t).bounds();
            tree.tree().near(box, [&](int u) {
                if (u <= t || !box.overlaps(triangle_of(mesh_, u).bounds()) || share(t, u, 2))
                    return;
                if (edge_through(t, u) || edge_through(u, t)) refuse_crossing(t, u);
            });
        }
    }

    // The contribution of a face to the winding number around p: the solid angle of the face, seen
    // from p, divided by 4π.
    double winding(const Triangle& triangle, const Vector3d& p) const
    {
        const Vector3d a = triangle.a - p, b = triangle.b - p, c = triangle.c - p;
        const double l = a.norm(), m = b.norm(), n = c.norm();
        const double volume = a.dot(b.cross(c));
        const double rest = l * m * n + a.dot(b) * n + b.dot(c) * l + c.dot(a) * m;
        return 2 * std::atan2(volume, rest) / (4 * std::numbers::pi);
    }

    // Refuses a piece unless material lies on the inner side of its faces and none on their outer
    // side: the winding number of the whole surface is then 1 on the inner side, 0 on the outer.
    void check_pieces(const std::vector<HalfEdge>& edges) const
    {
        const int count = static_cast<int>(mesh_.triangles.size());
        std::vector<int> parent(mesh_.triangles.size());
        std::iota(parent.begin(), parent.end(), 0);
        const auto root = [&](int t) {
            while (parent[t] != t)
                t = parent[t] = parent[parent[t]];
            return t;
        };
        for (std::size_t i = 0; i < edges.size(); i += 2)
            parent[root(edges[i].triangle)] = root(edges[i + 1].triangle);

        std::vector<char> is_seen(mesh_.triangles.size(), 0);
        std::vector<int> firsts; // the first face of each piece
        for (int t = 0; t < count; ++t)
            if (!std::exchange(is_seen[root(t)], 1)) firsts.push_back(t);
        if (firsts.size() == 1) return;
        if (firsts.size() > most_pieces)
            throw MeshError(line(firsts[most_pieces]), "expected at most " +
                                                           std::to_string(most_pieces) +
                                                           " separate pieces, found more");
        for (const int first : firsts) {
            const Triangle triangle = triangle_of(mesh_, first);
            const Vector3d middle = (triangle.a + triangle.b + triangle.c) / 3;
            // At a point on a face, the winding number is the mean of its values on both sides of
            // the face: 1/2. The face itself contributes nothing.
            double sum = 0;
            for (int t = 0; t < count; ++t)
                if (t != first) sum += winding(triangle_of(mesh_, t), middle);
            if (std::abs(sum - 0.5) > winding_tolerance)
                throw MeshError(line(first),
                                "expected pieces that lie apart, or hollows whose faces look "
                                "inwards, found " +
                                    face(first) + " inside another piece");
        }
    }

    const TriangleMesh& mesh_;
    const std::vector<int>& lines_;
    Bounds bounds_;
};

} // namespace

double signed_volume(const TriangleMesh& mesh)
{
    if (mesh.vertices.empty()) return 0;
    // The common apex of the tetrahedra in the sum. An apex near the mesh reduces cancellation.
    const Vector3d& o = mesh.vertices.front();
    double volume = 0;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vector3d a = mesh.vertices[i] - o, b = mesh.vertices[j] - o, c = mesh.vertices[k] - o;
        volume += a.dot(b.cross(c)) / 6;
    }
    return volume;
}

void check_mesh(const TriangleMesh& mesh, const std::vector<int>& lines)
{
    Check(mesh, lines).run();
}

} // namespace rigor
