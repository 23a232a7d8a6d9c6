// SPDX-License-Identifier: MIT
// Finds the contacts of two boxes by the separating axis test of Gottschalk, Lin and Manocha
// (1996). Of the six face normals and the nine cross products of edges, the test takes the axis
// with the largest separation; of nearly equal axes, it takes a face rather than edges. If the
// boxes are apart along this axis now but overlap at the end of the step, the code prefers a face
// that separates them now and along whose normal they will overlap less. Last, it clips the nearest
// face of the other box against the chosen face (Sutherland and Hodgman 1974), or takes the closest
// points of the two edges.
#include "rigid/detection/shapes/box_box.hpp"

#include "rigid/bodies/inlined_product.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

// Square of the sine of the angle below which two edges count as parallel; the angle is 0.06°. A
// face then separates the boxes as well as the edges do.
constexpr double parallel_squared = 1e-6;
// Distance from a border that counts as rounding, relative to half the width of the face.
constexpr double border_rounding = 1e-9;
// An axis is clearly better than another axis if its separation is larger by this multiple of the
// smallest half edge of both boxes. Otherwise a face is preferred to edges, and the larger face to
// the smaller one, so that a box at rest keeps its kind of contact from step to step.
constexpr double clear_difference = 0.01;

// A box in world space; its axes are the columns of R.
struct PlacedBox {
    Matrix3d R;
    Vector3d center, half;
};

// An axis that may separate the boxes: its direction, a unit vector, and the separation of the
// boxes along it [m], negative if they overlap. The axis is the normal of a face of one box, which
// has the index `axis1` in this box. Or it is perpendicular to an edge of box 1 along its axis
// `axis1` and to an edge of box 2 along its axis `axis2`.
struct Axis {
    double separation = -std::numeric_limits<double>::infinity();
    int axis1 = 0, axis2 = 0;
    Vector3d direction = Vector3d::Zero();
};

// Quantities that the test of each axis needs: C = AᵀB, where the columns of A and B are the
// axes of boxes a and b; the absolute values of the elements of C; and the vector from the
// center of a to that of b in the frame of each box.
struct RelativePose {
    Matrix3d C, C_abs;
    Vector3d d_a, d_b;

    RelativePose(const PlacedBox& a, const PlacedBox& b)
    {
        const Vector3d d = b.center - a.center;
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 3; ++i)
                C(i, j) = a.R.col(i).dot(b.R.col(j));
            C_abs.col(j) = C.col(j).cwiseAbs();
            d_a[j] = a.R.col(j).dot(d);
            d_b[j] = b.R.col(j).dot(d);
        }
    }
};

Vector3d turned_towards(const Vector3d& axis, const Vector3d& towards)
{
    return axis.dot(towards) < 0 ? Vector3d(-axis) : axis;
}

// The face of `a` with the largest separation. The direction points towards b.
Axis best_face(const PlacedBox& a, const PlacedBox& b, const RelativePose& of)
{
    Axis best;
    for (int i = 0; i < 3; ++i) {
        const double separation = std::abs(of.d_a[i]) - a.half[i] - of.C_abs.row(i).dot(b.half);
        if (separation > best.separation) best = {separation, i, 0, Vector3d::Zero()};
    }
    const Vector3d n = a.R.col(best.axis1);
    best.direction = of.d_a[best.axis1] < 0 ? Vector3d(-n) : n;
    return best;
}

// The face of `b` with the largest separation; the index of this axis of `b` is stored in `axis1`.
// The direction points towards a.
Axis best_other_face(const PlacedBox& a, const PlacedBox& b, const RelativePose& of)
{
    Axis best;
    for (int j = 0; j < 3; ++j) {
        const double separation = std::abs(of.d_b[j]) - b.half[j] - of.C_abs.col(j).dot(a.half);
        if (separation > best.separation) best = {separation, j, 0, Vector3d::Zero()};
    }
    const Vector3d n = b.R.col(best.axis1);
    best.direction = of.d_b[best.axis1] > 0 ? Vector3d(-n) : n;
    return best;
}

// The pair of edges with the largest separation (Gottschalk, Lin and Manocha 1996), if it is larger
// than `least`; otherwise an axis with the separation `least` and without a direction. The
// direction points from a to b. Parallel edges are skipped, since a face then separates the boxes
// as well as the edges do.
Axis best_edges(const PlacedBox& a, const PlacedBox& b, const RelativePose& of, double least)
{
    Axis best;
    best.separation = least;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            const double distance = std::abs(of.d_a[i2] * of.C(i1, j) - of.d_a[i1] * of.C(i2, j));
            const double reach = a.half[i1] * of.C_abs(i2, j) + a.half[i2] * of.C_abs(i1, j) +
                                 b.half[j1] * of.C_abs(i, j2) + b.half[j2] * of.C_abs(i, j1);
            const double between = distance - reach; // separation times axis length, which is ≤ 1
            if (between <= std::min(best.separation, 0.0)) continue;
            const double c = of.C(i, j), squared = 1 - c * c; // squared axis length
            if (squared < parallel_squared) continue;
            const double separation = between / std::sqrt(squared);
            if (separation > best.separation) best = {separation, i, j, Vector3d::Zero()};
        }
    if (best.separation > least) {
        const Vector3d l = a.R.col(best.axis1).cross(b.R.col(best.axis2)).normalized();
        best.direction = turned_towards(l, b.center - a.center);
    }
    return best;
}

// A face that separates the boxes now, and the separation along its normal after the move [m].
struct FaceAhead {
    double separation = -std::numeric_limits<double>::infinity();
    Axis axis;
    bool is_of_first = true;
};

// The face with the largest separation after the move, among the faces along whose normals the
// boxes overlap by at most `slop` now.
// @param move  displacement of box 1 relative to box 2 in this step
[[gnu::noinline]] FaceAhead best_face_ahead(const PlacedBox& a, const PlacedBox& b,
                                            const RelativePose& of, const Vector3d& move,
                                            double slop)
{
    FaceAhead best;
    for (const bool is_of_first : {true, false})
        for (int i = 0; i < 3; ++i) {
            const PlacedBox& box = is_of_first ? a : b;
            // Component along axis i of the vector from the center of `box` to that of the other.
            const double d = is_of_first ? of.d_a[i] : -of.d_b[i];
            const double reach =
                is_of_first ? of.C_abs.row(i).dot(b.half) : of.C_abs.col(i).dot(a.half);
            const double now = std::abs(d) - box.half[i] - reach;
            if (now < -slop) continue;
            const Vector3d out = d < 0 ? Vector3d(-box.R.col(i)) : Vector3d(box.R.col(i));
            const double then = now - (is_of_first ? 1 : -1) * move.dot(out);
            if (then > best.separation) best = {then, {now, i, 0, out}, is_of_first};
        }
    return best;
}

// A polygon with at most 8 vertices, in the frame of the reference face. In this frame, the face is
// |x| ≤ a, |y| ≤ b, where a and b are half the lengths of its edges, and z is the height above the
// face.
struct Polygon {
    std::array<Vector3d, 8> vertices; // the first `size` are set
    int size = 0;

    void add(const Vector3d& v)
    {
        if (size < 8) vertices[size++] = v;
    }
};

// Clips the polygon to sign v[axis] ≤ limit (Sutherland and Hodgman 1974). A vertex v on the border
// up to rounding counts as inside; otherwise rounding would add vertices where boxes are aligned.
void clip(Polygon& polygon, int axis, double sign, double limit)
{
    const double border = limit * (1 + border_rounding);
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
        // A vertex that counts as inside may lie slightly beyond the border, and the quotient of
        // two rounding errors may be any number. The clamp keeps the new vertex between `from` and
        // `to`.
        kept.add(from + std::clamp((limit - a) / (b - a), 0.0, 1.0) * (to - from));
    }
    polygon = kept;
}

// The face of `box` whose outward normal is most opposite to the third axis of the frame (R,
// origin). The result is in this frame.
Polygon incident_face(const PlacedBox& box, const Matrix3d& R, const Vector3d& origin)
{
    Matrix3d A; // Rᵀ R_box, the axes of the box in the frame
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

// Clips the incident face of `other` against the face of `reference` that `axis` names. Before
// that, the reference face is extended towards the side from which `other` comes: along each edge
// direction, by the component of the move in this direction.
// @param normal  contact normal, from box 2 to box 1
// @param move    displacement of `other` relative to `reference` in this step, or zero: then the
//                face is not extended
void find_face_contacts(const PlacedBox& reference, const PlacedBox& other, const Axis& axis,
                        const Vector3d& normal, const Vector3d& move, double reach,
                        std::vector<Contact>& contacts)
{
    const int k = axis.axis1, u = (k + 1) % 3, v = (k + 2) % 3;
    Matrix3d R; // frame of the face: two edges and the outward normal
    R.col(0) = reference.R.col(u);
    R.col(1) = reference.R.col(v);
    R.col(2) = axis.direction;
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
        contacts.push_back({origin + optimised::product(R, p), normal, gap});
    }
}

// The middle of an edge of `box`. Four edges are parallel to its axis `axis`; the edge that lies
// farthest in `direction` is taken.
Vector3d edge_middle(const PlacedBox& box, int axis, const Vector3d& direction)
{
    Vector3d middle = box.center;
    for (int i = 0; i < 3; ++i) {
        const double along = box.R.col(i).dot(direction);
        if (i != axis && along != 0) middle += std::copysign(box.half[i], along) * box.R.col(i);
    }
    return middle;
}

// The contact of two edges, at the closest points of both.
void find_edge_contacts(const PlacedBox& a, const PlacedBox& b, const Axis& axis, double reach,
                        std::vector<Contact>& contacts)
{
    const Vector3d u = a.R.col(axis.axis1), v = b.R.col(axis.axis2);
    const Vector3d p = edge_middle(a, axis.axis1, axis.direction);
    const Vector3d q = edge_middle(b, axis.axis2, -axis.direction);

    // Closest points p + s u and q + t v of the two lines, clamped to the edges.
    const double c = u.dot(v), d_u = u.dot(q - p), d_v = v.dot(q - p);
    const double s = (d_u - c * d_v) / (1 - c * c);
    const double t = (c * d_u - d_v) / (1 - c * c);
    const double half_s = a.half[axis.axis1], half_t = b.half[axis.axis2];
    const Vector3d on_a = p + std::clamp(s, -half_s, half_s) * u;
    const Vector3d on_b = q + std::clamp(t, -half_t, half_t) * v;
    if (axis.separation > 0 && (on_b - on_a).norm() >= reach) return; // the edges pass each other
    contacts.push_back({(on_a + on_b) / 2, -axis.direction, axis.separation});
}

// Whether the boxes overlap after the move of the first one, which means that no axis separates
// them.
bool overlap_after(const PlacedBox& a, const PlacedBox& b, const Vector3d& move)
{
    const PlacedBox moved{a.R, a.center + move, a.half};
    const RelativePose relation(moved, b);
    return best_face(moved, b, relation).separation < 0 &&
           best_other_face(moved, b, relation).separation < 0 &&
           best_edges(moved, b, relation, 0).separation <= 0;
}

double face_area(const PlacedBox& box, int axis)
{
    return box.half[(axis + 1) % 3] * box.half[(axis + 2) % 3];
}

} // namespace

void find_box_contacts(const Box& box1, const Pose& pose1, const Box& box2, const Pose& pose2,
                       const Vector3d& move, double reach, std::vector<Contact>& contacts)
{
    const PlacedBox a{pose1.R, pose1.X, box1.size / 2}, b{pose2.R, pose2.X, box2.size / 2};
    const RelativePose relation(a, b);
    const Axis face1 = best_face(a, b, relation);
    if (face1.separation >= reach) return;
    const Axis face2 = best_other_face(a, b, relation); // its direction points from 2 to 1
    if (face2.separation >= reach) return;

    const double smallest = std::min(a.half.minCoeff(), b.half.minCoeff());
    const double clearly = clear_difference * smallest, slop = penetration_slop * smallest;
    const double least = std::max(face1.separation, face2.separation) + clearly;
    const Axis edges = best_edges(a, b, relation, least);
    bool is_edges = edges.separation > least;
    const double better = face1.separation - face2.separation;
    const double larger = face_area(a, face1.axis1) - face_area(b, face2.axis1);
    bool is_first = std::abs(better) > clearly || larger == 0 ? better >= 0 : larger > 0;
    Axis face = is_first ? face1 : face2;

    const Axis& best = is_edges ? edges : face;
    const double then =
        best.separation - (is_edges || is_first ? 1 : -1) * move.dot(best.direction);
    Vector3d comes = Vector3d::Zero(); // move of the other box relative to the reference box
    if (best.separation > -slop && then < -slop) {
        const FaceAhead ahead = best_face_ahead(a, b, relation, move, slop);
        if (ahead.separation > then + slop) {
            is_edges = false;
            is_first = ahead.is_of_first;
            face = ahead.axis;
            comes = is_first ? Vector3d(-move) : move;
        }
    }
    if (is_edges) {
        if (edges.separation < reach) find_edge_contacts(a, b, edges, reach, contacts);
        return;
    }
    const Vector3d normal = is_first ? Vector3d(-face.direction) : face.direction;
    const PlacedBox &reference = is_first ? a : b, &other = is_first ? b : a;
    const std::size_t before = contacts.size();
    find_face_contacts(reference, other, face, normal, comes, reach, contacts);
    // Boxes that move towards each other diagonally may not face each other yet, so that clipping
    // removes the whole face. Then the reference face is extended by the move.
    if (contacts.size() > before || then >= -slop || !overlap_after(a, b, move)) return;
    comes = is_first ? Vector3d(-move) : move;
    find_face_contacts(reference, other, face, normal, comes, reach, contacts);
}

} // namespace rigor
