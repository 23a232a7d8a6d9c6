// SPDX-License-Identifier: MIT
// Looks for contacts that two shapes will have after their move in this step. The search for
// contacts runs once more, with shape 1 after its move relative to shape 2. The gap of each contact
// is then measured along the same normal before the move. At an edge, the planes of flat sides are
// tried too.
#include "rigid/detection/look_ahead.hpp"

#include "geometry/distance/support.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/detection/shape_contacts.hpp"
#include "rigid/detection/shapes/plane_contact.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace rigor {

namespace {

using Contacts = std::vector<Contact>;

bool is_concave(const Shape& shape)
{
    const Mesh* mesh = std::get_if<Mesh>(&shape);
    return mesh && !mesh->solid->is_convex();
}

// The overlap of two shapes that counts as touching [m].
double slop_between(const Shape& shape1, const Shape& shape2)
{
    const auto size = [](const Shape& shape) {
        const Bounds bounds = bounds_of(shape, {});
        return (bounds.high - bounds.low).norm();
    };
    return penetration_slop * std::min(size(shape1), size(shape2)) / 2;
}

// Appends the contacts with the part of a concave shape that another shape reaches in this step, as
// in a bowl, where the wall ahead is steeper than the wall below. Such a contact is found with
// shape 1 after its move relative to shape 2, and its gap is measured along the same normal before
// the move. The contact is kept under three conditions: the shapes would overlap there after the
// move, they do not overlap there now by more than the slop, and they have no other contact with
// this normal. Without such contacts, a shape would move into the wall, and the position correction
// would lift the shape, which adds energy.
//
// @param first  the contacts of these two shapes start at this index
void add_contacts_ahead(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                        const Pose& pose2, const MovingPair& pair, Counters& counters,
                        std::size_t first, Contacts& contacts)
{
    constexpr double overlapping = 0;    // reach of the search [m]: finds only overlaps
    constexpr double same_normal = 1e-4; // normals n, n' count as equal if |n - n'| is smaller
    const double way = pair.move.norm();
    const auto any_known = [&](const auto& is_such) {
        return std::any_of(contacts.begin() + static_cast<std::ptrdiff_t>(first), contacts.end(),
                           is_such);
    };
    if (!any_known([&](const Contact& c) { return c.gap < way; })) return;
    const double slop = slop_between(shape1, shape2);
    if (way < slop) return;
    Contacts ahead;
    find_shape_contacts(shape1, {pose1.R, pose1.X + pair.move}, shape2, pose2, {0, 0, 0},
                        overlapping, counters, ahead);
    for (const Contact& c : ahead) {
        const double now = c.gap - c.normal.dot(pair.move);
        if (now < -slop || any_known([&](const Contact& known) {
                return (known.normal - c.normal).norm() < same_normal;
            }))
            continue;
        contacts.push_back({c.point - pair.point_share() * pair.move, c.normal, now});
    }
}

// Whether a shape has flat sides with edges on which another shape may catch: a box, or a convex
// mesh that does not stand for a round body.
bool has_flat_sides(const Shape& shape)
{
    const Mesh* mesh = std::get_if<Mesh>(&shape);
    return std::holds_alternative<Box>(shape) ||
           (mesh && mesh->solid->is_convex() && mesh->solid->facet_angle() == 0);
}

// Whether the method for these two shapes does not look ahead, so that one of them may catch on an
// edge of the other.
bool may_catch(const Shape& shape1, const Shape& shape2)
{
    const auto is_box_or_sphere = [](const Shape& shape) {
        return std::holds_alternative<Box>(shape) || std::holds_alternative<Sphere>(shape);
    };
    if (is_box_or_sphere(shape1) && is_box_or_sphere(shape2)) return false;
    for (const Shape* shape : {&shape1, &shape2})
        if (std::holds_alternative<Plane>(*shape) || is_concave(*shape)) return false;
    return has_flat_sides(shape1) || has_flat_sides(shape2);
}

// The outward normals of the flat sides of a shape, in object space.
std::vector<Vector3d> side_normals(const Shape& shape)
{
    std::vector<Vector3d> normals;
    if (has_flat_sides(shape)) add_face_normals(shape, Vector3d::UnitY(), normals);
    return normals;
}

// Whether a normal is that of a flat side of one of the two shapes.
bool is_of_side(const Vector3d& n, const Shape& shape1, const Pose& pose1, const Shape& shape2,
                const Pose& pose2)
{
    constexpr double same = 1e-12; // 1 - n·n' of normals that count as equal: an angle of 1e-6
    const auto has = [&](const Shape& shape, const Pose& pose, double sign) {
        const Vector3d out = sign * (pose.R.transpose() * n);
        const std::vector<Vector3d> normals = side_normals(shape);
        return std::any_of(normals.begin(), normals.end(),
                           [&](const Vector3d& side) { return side.dot(out) > 1 - same; });
    };
    return has(shape1, pose1, -1) || has(shape2, pose2, 1);
}

// Whether a point that moves by m may pass over a flat side, seen along the normal n. The bounds of
// the side and of the point's way are compared, with axes along and across the first edge.
bool may_pass_over(const Feature& side, const Vector3d& n, const Vector3d& p, const Vector3d& m)
{
    const Vector3d along = side.points[1] - side.points[0];
    for (const Vector3d& axis : {along, Vector3d(n.cross(along))}) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (int i = 0; i < side.count; ++i) {
            low = std::min(low, axis.dot(side.points[i]));
            high = std::max(high, axis.dot(side.points[i]));
        }
        const double start = axis.dot(p), end = start + axis.dot(m);
        if (std::max(start, end) < low || std::min(start, end) > high) return false;
    }
    return true;
}

// The contacts of a shape with the plane of a flat side of another one, of the side from which it
// is farthest after its move, if it is not below this plane now by more than the slop. Contacts
// beside the side are left out, unless the move brings them over it.
// @param move  displacement of the shape relative to the other one
// @param then  replaced by the distance from the plane after the move, if that is larger [m]
// @return nothing if there is no side that is farther away after the move than `then`
std::optional<Contacts> contacts_with_side(const Shape& shape, const Pose& pose, const Shape& other,
                                           const Pose& pose_of_other, const Vector3d& move,
                                           double reach, double slop, double& then)
{
    std::optional<Contacts> best;
    const Vector3d m = pose_of_other.R.transpose() * move;
    for (const Vector3d& n : side_normals(other)) {
        const Feature side = feature_towards(other, n);
        if (side.count < 3) continue;
        const Matrix3d R =
            pose_of_other.R *
            Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitY(), n).toRotationMatrix();
        Contacts all;
        find_plane_contacts(shape, pose, {R, pose_of_other * side.points[0]},
                            std::numeric_limits<double>::infinity(), all);
        double now = std::numeric_limits<double>::infinity();
        for (const Contact& c : all)
            now = std::min(now, c.gap);
        const double after = now + n.dot(m);
        if (now < -slop || after <= then) continue;
        then = after;
        std::erase_if(all, [&](const Contact& c) {
            const Vector3d p = pose_of_other.R.transpose() * (c.point - pose_of_other.X);
            return c.gap >= reach || !may_pass_over(side, n, p, m);
        });
        best = all;
    }
    return best;
}

// The contact along whose normal the shapes would overlap most after their move, without those at
// which a shape rests on a flat side; nothing if they would not overlap.
std::optional<Contact> worst_after(const std::vector<Contact>& contacts, std::size_t first,
                                   const Vector3d& move, double slop, const auto& is_side)
{
    std::optional<Contact> worst;
    double least = 0;
    for (std::size_t k = first; k < contacts.size(); ++k) {
        const Contact& c = contacts[k];
        const double after = c.gap + c.normal.dot(move);
        const bool rests = c.gap <= slop && after >= -slop && is_side(c.normal);
        if (rests || after >= least) continue;
        worst = c;
        least = after;
    }
    return worst;
}

// Replaces the contacts of two shapes under three conditions: after their move, the shapes would
// overlap along the normal of an edge or corner; they would overlap less along other normals; and
// now they do not overlap along these by more than the slop. The other contacts are those that the
// shapes have after their move, or those with the plane of a flat side.
void replace_edge_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                           const Pose& pose2, const MovingPair& pair, double reach,
                           Counters& counters, std::size_t first, Contacts& contacts)
{
    // The search looks ahead a little farther than the step. Otherwise, shapes that only just touch
    // after the move might touch at their edges.
    constexpr double farther = 1 + 1e-3;
    const Vector3d move = farther * pair.move;
    const double way = move.norm(), slop = slop_between(shape1, shape2);
    const auto is_side = [&](const Vector3d& n) {
        return is_of_side(n, shape1, pose1, shape2, pose2);
    };
    const std::optional<Contact> worst = worst_after(contacts, first, move, slop, is_side);
    if (!worst) return;
    double then = worst->gap + worst->normal.dot(move);
    Contacts after;
    find_shape_contacts(shape1, {pose1.R, pose1.X + move}, shape2, pose2, {0, 0, 0}, reach + way,
                        counters, after);
    const bool is_better = std::all_of(after.begin(), after.end(), [&](const Contact& c) {
        constexpr double same_normal = 1e-6; // normals n, n' count as equal if |n - n'| is smaller
        return c.gap > then && c.gap - c.normal.dot(move) > -slop &&
               (c.normal - worst->normal).norm() > same_normal;
    });
    if (is_better) {
        contacts.resize(first);
        for (const Contact& c : after)
            if (const double now = c.gap - c.normal.dot(move); now < reach)
                contacts.push_back({c.point - pair.point_share() * move, c.normal, now});
        return;
    }
    // A side along whose normal the overlap is about as large would not be better.
    constexpr double noticeable = 1e-6;
    then += noticeable * way;
    std::optional<Contacts> sides =
        contacts_with_side(shape1, pose1, shape2, pose2, move, reach, slop, then);
    if (auto of_1 = contacts_with_side(shape2, pose2, shape1, pose1, -move, reach, slop, then)) {
        for (Contact& c : *of_1)
            c.normal = -c.normal;
        sides = of_1;
    }
    if (!sides) return;
    contacts.resize(first);
    contacts.insert(contacts.end(), sides->begin(), sides->end());
}

} // namespace

void look_ahead(const Shape& shape1, const Pose& pose1, const Shape& shape2, const Pose& pose2,
                const MovingPair& pair, double reach, Counters& counters, std::size_t first,
                std::vector<Contact>& contacts)
{
    const bool is_worth_its_time = (is_concave(shape1) && (pair.is_still1 || has_core(shape2))) ||
                                   (is_concave(shape2) && (pair.is_still2 || has_core(shape1)));
    if (is_worth_its_time)
        add_contacts_ahead(shape1, pose1, shape2, pose2, pair, counters, first, contacts);
    else if (may_catch(shape1, shape2))
        replace_edge_contacts(shape1, pose1, shape2, pose2, pair, reach, counters, first, contacts);
}

} // namespace rigor
