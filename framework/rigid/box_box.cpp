// SPDX-License-Identifier: MIT
#include "rigid/box_box.hpp"

#include "rigid/box_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {

namespace {

// A polygon with at most 8 vertices, in the frame of the reference face: the face is |x| ≤ half x,
// |y| ≤ half y, and z is the height above it.
struct Polygon {
    std::array<Vector3d, 8> vertices; // the first `size` are set
    int size = 0;

    void add(const Vector3d& v)
    {
        if (size < 8) vertices[size++] = v;
    }
};

// Keeps what lies on the inner side of sign x[axis] ≤ limit (Sutherland and Hodgman 1974). A vertex
// within rounding of the border is inside: otherwise aligned boxes get chance vertices.
void clip(Polygon& polygon, int axis, double sign, double limit)
{
    const double border = limit * (1 + 1e-9);
    const auto is_inside = [&](const Vector3d& v) { return sign * v[axis] <= border; };
    const auto begin = polygon.vertices.begin(), end = begin + polygon.size;
    if (std::all_of(begin, end, is_inside)) return;
    Polygon kept;
    for (int i = 0; i < polygon.size; ++i) {
        const Vector3d& from = polygon.vertices[i];
        const Vector3d& to = polygon.vertices[i + 1 < polygon.size ? i + 1 : 0];
        if (is_inside(from)) kept.add(from);
        if (is_inside(from) == is_inside(to)) continue;
        const double a = sign * from[axis], b = sign * to[axis];
        kept.add(from + (limit - a) / (b - a) * (to - from));
    }
    polygon = kept;
}

// The face of `box` that looks most against the third axis of the frame (R, origin), in that frame.
Polygon incident_face(const PlacedBox& box, const Matrix3d& R, const Vector3d& origin)
{
    Matrix3d A; // Rᵀ R_box: the axes of the box in the frame
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            A(i, j) = R.col(i).dot(box.R.col(j));
    int k = 0;
    A.row(2).cwiseAbs().maxCoeff(&k);
    const int u = (k + 1) % 3, v = (k + 2) % 3;
    const Vector3d d = box.center - origin;
    const Vector3d to_center(R.col(0).dot(d), R.col(1).dot(d), R.col(2).dot(d));
    const Vector3d center = to_center + (A(2, k) > 0 ? -1 : 1) * box.half[k] * A.col(k);
    const Vector3d e_u = box.half[u] * A.col(u), e_v = box.half[v] * A.col(v);

    Polygon face;
    face.add(center + e_u + e_v);
    face.add(center - e_u + e_v);
    face.add(center - e_u - e_v);
    face.add(center + e_u - e_v);
    return face;
}

// Clips the incident face of `other` against the face of `reference` that `axis` names, and against as
// much beside it as `other` will come from.
// @param normal  of the contact, from box 2 to box 1
// @param move    of `other`, against `reference`, in the step to come
void touch_face(const PlacedBox& reference, const PlacedBox& other, const BoxAxis& axis,
                const Vector3d& normal, const Vector3d& move, double reach,
                std::vector<Touch>& touches)
{
    const int k = axis.axis1, u = (k + 1) % 3, v = (k + 2) % 3;
    Matrix3d R; // of the face: two edges and the outward normal
    R << reference.R.col(u), reference.R.col(v), axis.direction;
    const Vector3d origin = reference.center + reference.half[k] * axis.direction;

    Polygon polygon = incident_face(other, R, origin);
    for (const double sign : {-1.0, 1.0}) {
        clip(polygon, 0, sign, reference.half[u] + std::max(0.0, -sign * move.dot(R.col(0))));
        clip(polygon, 1, sign, reference.half[v] + std::max(0.0, -sign * move.dot(R.col(1))));
    }
    for (int i = 0; i < polygon.size; ++i) {
        Vector3d p = polygon.vertices[i];
        const double gap = p.z();
        if (gap >= reach) continue;
        p.z() /= 2; // in the middle of the gap
        touches.push_back({origin + R * p, normal, gap});
    }
}

// Middle of the edge of `box` along its axis `axis` that lies farthest in `direction`.
Vector3d edge_middle(const PlacedBox& box, int axis, const Vector3d& direction)
{
    Vector3d corner = (box.R.transpose() * direction).cwiseSign().cwiseProduct(box.half);
    corner[axis] = 0;
    return box.center + box.R * corner;
}

void touch_edges(const PlacedBox& a, const PlacedBox& b, const BoxAxis& axis, double reach,
                 std::vector<Touch>& touches)
{
    const Vector3d u = a.R.col(axis.axis1), v = b.R.col(axis.axis2);
    const Vector3d p = edge_middle(a, axis.axis1, axis.direction);
    const Vector3d q = edge_middle(b, axis.axis2, -axis.direction);

    // closest points p + s u, q + t v of the two lines, held to the edges
    const double c = u.dot(v), d_u = u.dot(q - p), d_v = v.dot(q - p);
    const double s = (d_u - c * d_v) / (1 - c * c);
    const double t = (c * d_u - d_v) / (1 - c * c);
    const double half_s = a.half[axis.axis1], half_t = b.half[axis.axis2];
    const Vector3d on_a = p + std::clamp(s, -half_s, half_s) * u;
    const Vector3d on_b = q + std::clamp(t, -half_t, half_t) * v;
    if (axis.separation > 0 && (on_b - on_a).norm() >= reach) return; // they pass by each other
    touches.push_back({(on_a + on_b) / 2, -axis.direction, axis.separation});
}

double face_area(const PlacedBox& box, int axis)
{
    return box.half[(axis + 1) % 3] * box.half[(axis + 2) % 3];
}

} // namespace

void touch_boxes(const Box& box1, const Pose& pose1, const Box& box2, const Pose& pose2,
                 const Vector3d& move, double reach, std::vector<Touch>& touches)
{
    const PlacedBox a{pose1.R, pose1.X, box1.size / 2}, b{pose2.R, pose2.X, box2.size / 2};
    const BoxRelation relation(a, b);
    const BoxAxis face1 = best_face(a, b, relation);
    if (face1.separation >= reach) return;
    const BoxAxis face2 = best_other_face(a, b, relation); // its direction points from 2 to 1
    if (face2.separation >= reach) return;

    const double smallest = std::min(a.half.minCoeff(), b.half.minCoeff());
    const double clearly = 0.01 * smallest, slop = 1e-4 * smallest;
    const double least = std::max(face1.separation, face2.separation) + clearly;
    const BoxAxis edges = best_edges(a, b, relation, least);
    const bool is_edges = edges.separation > least;
    const double better = face1.separation - face2.separation;
    const double larger = face_area(a, face1.axis1) - face_area(b, face2.axis1);
    const bool is_first = std::abs(better) > clearly || larger == 0 ? better >= 0 : larger > 0;

    const BoxAxis& best = is_edges ? edges : is_first ? face1 : face2;
    const double then =
        best.separation - (is_edges || is_first ? 1 : -1) * move.dot(best.direction);
    if (best.separation > -slop && then < -slop) {
        const FaceAhead ahead = best_face_ahead(a, b, relation, move, slop);
        if (ahead.separation > then + slop) {
            if (ahead.is_of_first)
                return touch_face(a, b, ahead.axis, -ahead.axis.direction, -move, reach, touches);
            return touch_face(b, a, ahead.axis, ahead.axis.direction, move, reach, touches);
        }
    }
    if (is_edges) {
        if (edges.separation < reach) touch_edges(a, b, edges, reach, touches);
        return;
    }
    const Vector3d still = Vector3d::Zero();
    if (is_first)
        touch_face(a, b, face1, -face1.direction, still, reach, touches);
    else
        touch_face(b, a, face2, face2.direction, still, reach, touches);
}

} // namespace rigor
