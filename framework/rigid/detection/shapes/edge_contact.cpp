// SPDX-License-Identifier: MIT
// Finds the contacts between the sharp edges of two shapes. For each edge of shape 1, a bounding
// tree gives the edges of the mesh near it. Two edges make a contact if the closest points of their
// lines lie on both edges and the normal lies between the normals of the two faces at each edge.
#include "rigid/detection/shapes/edge_contact.hpp"

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/solid_mesh.hpp"

#include <cmath>

namespace rigor {

namespace {

// Sine of the smallest angle at which two edges make a contact; the angle is about 3°. At smaller
// angles, the end points of the edges make the contacts instead, because the closest points of
// almost parallel lines move far if a body rotates a little. The angle was chosen by trial.
constexpr double parallel = 0.05;
constexpr double rounding = 1e-6; // relative rounding error of a direction
// Deepest overlap at which two edges make a contact, relative to the longest side of the bounds of
// the mesh's edges. Deeper overlaps are left to the surface points, where the level set gives the
// nearest way out. The share was chosen by trial.
constexpr double deepest_share = 0.05;

std::vector<SharpEdge> box_edges(const Box& box)
{
    std::vector<SharpEdge> edges;
    for (int axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < 4; ++corner) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const Vector3d n1 = (corner & 1 ? 1 : -1) * Vector3d::Unit(u);
            const Vector3d n2 = (corner & 2 ? 1 : -1) * Vector3d::Unit(v);
            const Vector3d middle = (n1 + n2).cwiseProduct(box.size / 2);
            const Vector3d half = box.size[axis] / 2 * Vector3d::Unit(axis);
            edges.push_back({middle - half, middle + half, n1, n2, 0});
        }
    return edges;
}

SharpEdge moved(const SharpEdge& e, const Pose& pose)
{
    return {pose * e.from, pose * e.to, pose.R * e.normal1, pose.R * e.normal2, e.cone};
}

// Whether n, perpendicular to the edge, lies between the normals of the edge's two faces.
bool is_between(const Vector3d& n, const SharpEdge& edge)
{
    const Vector3d axis = edge.normal1.cross(edge.normal2);
    return edge.normal1.cross(n).dot(axis) >= -rounding &&
           n.cross(edge.normal2).dot(axis) >= -rounding && n.dot(edge.normal1 + edge.normal2) > 0;
}

// @param deepest  deeper overlaps are not contacts of edges [m]
void find_contact_of_edges(const SharpEdge& a, const SharpEdge& b, double reach, double deepest,
                           std::vector<Contact>& contacts)
{
    const Vector3d u = a.to - a.from, v = b.to - b.from, across = u.cross(v);
    const double area = across.norm();
    if (!(area > parallel * u.norm() * v.norm())) return;
    Vector3d n = across / area;
    if (n.dot(b.normal1 + b.normal2) < 0) n = -n;
    const Vector3d d = b.from - a.from;
    const double gap = -d.dot(n);
    if (gap >= reach || gap < -deepest) return;
    // Parameters of the points where the lines a.from + s u and b.from + t v are closest.
    const double s = d.cross(v).dot(across) / (area * area);
    const double t = d.cross(u).dot(across) / (area * area);
    if (s < 0 || s > 1 || t < 0 || t > 1) return;
    if (!is_between(n, b) || !is_between(-n, a)) return;
    contacts.push_back({(a.from + s * u + b.from + t * v) / 2, n, gap});
}

} // namespace

void find_edge_contacts(const Shape& shape1, const Pose& pose, const MeshSurface& surface2,
                        double reach, std::vector<Contact>& contacts)
{
    if (surface2.edge_tree().empty()) return;
    Bounds near = surface2.edge_tree().nodes()[0].bounds;
    const double deepest = deepest_share * (near.high - near.low).maxCoeff();
    const double slack = std::max(reach, deepest);
    near.grow(slack);
    const auto against_2 = [&](const SharpEdge& edge) {
        const SharpEdge a = moved(edge, pose);
        Bounds bounds{a.from.cwiseMin(a.to), a.from.cwiseMax(a.to)};
        bounds.grow(slack);
        if (!bounds.overlaps(near)) return;
        surface2.edge_tree().near(bounds, [&](int i) {
            find_contact_of_edges(a, surface2.edges()[i], reach, deepest, contacts);
        });
    };
    if (const Box* box = std::get_if<Box>(&shape1))
        for (const SharpEdge& edge : box_edges(*box))
            against_2(edge);
    if (const Mesh* mesh = std::get_if<Mesh>(&shape1))
        for (const SharpEdge& edge : mesh->solid->surface().edges())
            against_2(edge);
}

} // namespace rigor
