// SPDX-License-Identifier: MIT
// Treats a convex mesh as a polyhedron. The support point (Gilbert, Johnson and Keerthi 1988) is
// found by hill climbing from vertex to vertex (Ericson 2005, "Real-time collision detection",
// 9.5.4). The constructor first merges triangles into flat faces. Then it finds the corners of the
// faces: vertices inside a face or along an edge belong to the triangulation and not to the solid.
// Then it links neighbors and finds the six extreme vertices.
#include "geometry/convex/hull.hpp"

#include "geometry/meshes/triangle.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// A point is in a plane if its distance from the plane, divided by the size of the mesh
// (`size_of`), is below this. The value is above the rounding of coordinates from a file, and far
// below the depth of any hollow that is modeled on purpose.
constexpr double flat = 1e-9;

// Triangles are in one flat face if their unit normals differ by less than this. It is more than
// `flat`, because the shape of a triangle makes its normal less exact than positions are.
constexpr double same_normal = 1e-7;

// The largest number of face normals that `separation` (distance/separation.hpp) tries as
// directions. It limits the time of one call.
constexpr std::size_t most_normals = 32;

// The longest edge of the box that bounds the mesh [m].
double size_of(const TriangleMesh& mesh)
{
    const Bounds bounds = bounds_of(mesh);
    return (bounds.high - bounds.low).maxCoeff();
}

} // namespace

bool is_hull(const TriangleMesh& mesh)
{
    if (mesh.vertices.size() > Hull::most_vertices) return false;
    const double tolerance = flat * size_of(mesh);
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        const Triangle triangle = triangle_of(mesh, t);
        const Vector3d n = triangle.area_normal().normalized();
        for (const Vector3d& v : mesh.vertices)
            if (n.dot(v - triangle.a) > tolerance) return false;
    }
    return true;
}

Hull::Hull(const TriangleMesh& mesh) : vertices_(mesh.vertices)
{
    merge_faces(mesh);
    find_corners(flat * size_of(mesh));
    link_neighbours();
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1}) {
            int best = -1;
            for (int v = 0; v < static_cast<int>(vertices_.size()); ++v) {
                if (neighbours_[v].empty()) continue; // v is not a corner of a face
                const double gain = best < 0 ? 0 : vertices_[v][axis] - vertices_[best][axis];
                if (best < 0 || (side ? gain : -gain) > 0) best = v;
            }
            extremes_[2 * axis + side] = best;
        }
}

void Hull::merge_faces(const TriangleMesh& mesh)
{
    const double tolerance = flat * size_of(mesh);
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        const Triangle triangle = triangle_of(mesh, t);
        const double area = triangle.area_normal().norm();
        const Vector3d n = triangle.area_normal() / area;
        const auto same = std::find_if(faces_.begin(), faces_.end(), [&](const Face& face) {
            return (face.normal - n).norm() < same_normal &&
                   std::abs(n.dot(vertices_[face.corners[0]] - triangle.a)) <= tolerance;
        });
        if (same != faces_.end()) {
            same->area += area;
            continue;
        }
        Face face{n, area, {}};
        for (int v = 0; v < static_cast<int>(vertices_.size()); ++v)
            if (n.dot(vertices_[v] - triangle.a) >= -tolerance) face.corners.push_back(v);
        const Vector3d middle = (triangle.a + triangle.b + triangle.c) / 3;
        const Vector3d x = (triangle.a - middle).normalized(), y = n.cross(x);
        const auto angle = [&](int v) {
            const Vector3d p = vertices_[v] - middle;
            return std::atan2(p.dot(y), p.dot(x));
        };
        std::sort(face.corners.begin(), face.corners.end(),
                  [&](int v, int w) { return angle(v) < angle(w); });
        faces_.push_back(std::move(face));
    }
    std::vector<const Face*> largest;
    for (const Face& face : faces_)
        largest.push_back(&face);
    std::stable_sort(largest.begin(), largest.end(),
                     [](const Face* a, const Face* b) { return a->area > b->area; });
    largest.resize(std::min(largest.size(), most_normals));
    for (const Face* face : largest)
        face_normals_.push_back(face->normal);
}

// The corners of the convex hull of a face's vertices, counter-clockwise, by Andrew's monotone
// chain (Andrew 1979). Points within the tolerance of a side are left out.
std::vector<int> Hull::outline(const Face& face, double tolerance) const
{
    int least = 0;
    face.normal.cwiseAbs().minCoeff(&least);
    const Vector3d x = face.normal.cross(Vector3d::Unit(least)).normalized();
    const Vector3d y = face.normal.cross(x);
    std::vector<int> sorted = face.corners;
    std::sort(sorted.begin(), sorted.end(), [&](int v, int w) {
        const double p = x.dot(vertices_[v]), q = x.dot(vertices_[w]);
        return p != q ? p < q : y.dot(vertices_[v]) < y.dot(vertices_[w]);
    });
    // Whether b lies to the right of the line from a to c, so that the outline bends at b.
    const auto bends = [&](int a, int b, int c) {
        const Vector3d along = vertices_[c] - vertices_[a], to_b = vertices_[b] - vertices_[a];
        return to_b.cross(along).dot(face.normal) > tolerance * along.norm();
    };
    std::vector<int> corners;
    for (int pass = 0; pass < 2; ++pass) { // the lower chain, then the upper one
        const std::size_t first = corners.size();
        for (const int v : sorted) {
            while (corners.size() >= first + 2 &&
                   !bends(corners[corners.size() - 2], corners.back(), v))
                corners.pop_back();
            corners.push_back(v);
        }
        corners.pop_back(); // the next chain begins with this corner
        std::reverse(sorted.begin(), sorted.end());
    }
    return corners;
}

void Hull::find_corners(double tolerance)
{
    std::vector<char> is_corner(vertices_.size(), false);
    for (const Face& face : faces_)
        for (const int v : outline(face, tolerance))
            is_corner[v] = true;
    for (Face& face : faces_)
        std::erase_if(face.corners, [&](int v) { return !is_corner[v]; });
}

void Hull::link_neighbours()
{
    neighbours_.resize(vertices_.size());
    for (const Face& face : faces_)
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
            const int v = face.corners[i], next = face.corners[(i + 1) % face.corners.size()];
            neighbours_[v].push_back(next);
            neighbours_[next].push_back(v);
        }
    for (std::vector<int>& around : neighbours_) {
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
    }
}

// Climbs to the vertex that is highest along d. Of the directions -x, +x, -y, …, the one nearest to
// d is chosen, and the climb starts at the extreme vertex in this direction. On a convex polyhedron
// a vertex without a higher neighbor is the highest.
int Hull::farthest(const Vector3d& d) const
{
    int axis = 0;
    d.cwiseAbs().maxCoeff(&axis);
    int at = extremes_[2 * axis + (d[axis] > 0 ? 1 : 0)];
    double height = d.dot(vertices_[at]);
    for (bool climbs = true; climbs;) {
        climbs = false;
        for (const int neighbour : neighbours_[at]) {
            const double h = d.dot(vertices_[neighbour]);
            if (h <= height) continue;
            at = neighbour;
            height = h;
            climbs = true;
            break;
        }
    }
    return at;
}

Vector3d Hull::support(const Vector3d& direction) const
{
    return vertices_[farthest(direction)];
}

Feature Hull::feature_towards(const Vector3d& d) const
{
    const auto facing =
        std::max_element(faces_.begin(), faces_.end(), [&](const Face& a, const Face& b) {
            return a.normal.dot(d) < b.normal.dot(d);
        });
    Feature feature;
    if (facing->normal.dot(d) > Feature::facing_cosine) {
        const std::size_t n = facing->corners.size();
        const std::size_t kept = std::min<std::size_t>(n, Feature::most);
        for (std::size_t i = 0; i < kept; ++i)
            feature.add(vertices_[facing->corners[i * n / kept]]);
        return feature;
    }
    const int corner = farthest(d);
    int other = -1;
    double flattest = Feature::facing_sine;
    for (const int neighbour : neighbours_[corner]) {
        const double slope =
            std::abs(d.dot((vertices_[neighbour] - vertices_[corner]).normalized()));
        if (slope >= flattest) continue;
        flattest = slope;
        other = neighbour;
    }
    feature.add(vertices_[corner]);
    if (other >= 0) feature.add(vertices_[other]);
    return feature;
}

} // namespace rigor
