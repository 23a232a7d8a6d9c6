// SPDX-License-Identifier: MIT
// Looks for contacts that two shapes will have after their move in this step. The search for
// contacts runs once more, with shape 1 after its move relative to shape 2. The gap of each contact
// is then measured along the same normal before the move. At an edge of a box, the planes of the
// faces are tried too.
#include "rigid/detection/look_ahead.hpp"

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
    return resting_overlap * std::min(size(shape1), size(shape2)) / 2;
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

// Whether a normal is that of a face of one of the two shapes that are boxes.
bool is_of_face(const Vector3d& n, const Shape& shape1, const Pose& pose1, const Shape& shape2,
                const Pose& pose2)
{
    constexpr double same = 1e-12; // 1 - n·n' of normals that count as equal: an angle of 1e-6
    const auto is_face = [&](const Shape& shape, const Pose& pose) {
        return std::holds_alternative<Box>(shape) &&
               (pose.R.transpose() * n).cwiseAbs().maxCoeff() > 1 - same;
    };
    return is_face(shape1, pose1) || is_face(shape2, pose2);
}

// Whether one of the shapes is a box, on whose edge the other may catch, since the method for these
// two shapes does not look ahead.
bool may_catch(const Shape& shape1, const Shape& shape2)
{
    const auto looks_ahead = [](const Shape& shape) {
        return std::holds_alternative<Box>(shape) || std::holds_alternative<Sphere>(shape) ||
               std::holds_alternative<Plane>(shape) || is_concave(shape);
    };
    return (std::holds_alternative<Box>(shape1) && !looks_ahead(shape2)) ||
           (std::holds_alternative<Box>(shape2) && !looks_ahead(shape1));
}

// A face of a box: its outward normal and its middle are y and the origin of this pose.
Pose face_of(const Box& box, const Pose& pose, int axis, double side)
{
    Matrix3d R;
    R << pose.R.col((axis + 2) % 3), side * pose.R.col(axis), pose.R.col((axis + 1) % 3);
    return {R, pose * Vector3d(side * box.size[axis] / 2 * Vector3d::Unit(axis))};
}

// The contacts of a shape with the plane of the face of a box from which it is farthest after its
// move, if it is not below this plane now by more than the slop. Contacts beside the face are left
// out, unless the move brings them over it.
// @param move  of the shape relative to the box
// @param then  replaced by the distance from the plane after the move, if that is larger [m]
// @return nothing if there is no face that is farther away after the move than `then`
std::optional<Contacts> contacts_with_face(const Shape& shape, const Pose& pose, const Box& box,
                                           const Pose& pose_of_box, const Vector3d& move,
                                           double reach, double slop, double& then)
{
    std::optional<Contacts> best;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1., 1.}) {
            const Pose face = face_of(box, pose_of_box, axis, side);
            Contacts all;
            find_plane_contacts(shape, pose, face, std::numeric_limits<double>::infinity(), all);
            double now = std::numeric_limits<double>::infinity();
            for (const Contact& c : all)
                now = std::min(now, c.gap);
            const double after = now + face.R.col(1).dot(move);
            if (now < -slop || after <= then) continue;
            then = after;
            const double half_x = box.size[(axis + 2) % 3] / 2,
                         half_z = box.size[(axis + 1) % 3] / 2;
            const Vector3d m = face.R.transpose() * move;
            std::erase_if(all, [&](const Contact& c) {
                const Vector3d p = face.R.transpose() * (c.point - face.X);
                return c.gap >= reach || std::max(p.x(), p.x() + m.x()) < -half_x ||
                       std::min(p.x(), p.x() + m.x()) > half_x ||
                       std::max(p.z(), p.z() + m.z()) < -half_z ||
                       std::min(p.z(), p.z() + m.z()) > half_z;
            });
            best = all;
        }
    return best;
}

// The contact along whose normal the shapes would overlap most after their move, without those at
// which a shape rests on a face; nothing if they would not overlap.
std::optional<Contact> worst_after(const std::vector<Contact>& contacts, std::size_t first,
                                   const Vector3d& move, double slop, const auto& is_face)
{
    std::optional<Contact> worst;
    double least = 0;
    for (std::size_t k = first; k < contacts.size(); ++k) {
        const Contact& c = contacts[k];
        const double after = c.gap + c.normal.dot(move);
        const bool rests = c.gap <= slop && after >= -slop && is_face(c.normal);
        if (rests || after >= least) continue;
        worst = c;
        least = after;
    }
    return worst;
}

// Replaces the contacts of a box and another shape, if the shapes would overlap after their move
// along the normal of an edge or corner, would overlap less along other normals, and do not overlap
// along these now by more than the slop. The other contacts are those that the shapes have after
// their move, or those with the plane of a face.
void replace_edge_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                           const Pose& pose2, const MovingPair& pair, double reach,
                           Counters& counters, std::size_t first, Contacts& contacts)
{
    // The search looks ahead a little farther than the step. Otherwise, shapes that only just touch
    // after the move might touch at their edges.
    constexpr double farther = 1 + 1e-3;
    const Vector3d move = farther * pair.move;
    const double way = move.norm(), slop = slop_between(shape1, shape2);
    const auto is_face = [&](const Vector3d& n) {
        return is_of_face(n, shape1, pose1, shape2, pose2);
    };
    const std::optional<Contact> worst = worst_after(contacts, first, move, slop, is_face);
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
    // A face along whose normal the overlap is about as large would not be better.
    constexpr double noticeable = 1e-6;
    then += noticeable * way;
    std::optional<Contacts> faced;
    if (const Box* box2 = std::get_if<Box>(&shape2)) {
        faced = contacts_with_face(shape1, pose1, *box2, pose2, move, reach, slop, then);
    } else {
        faced = contacts_with_face(shape2, pose2, std::get<Box>(shape1), pose1, -move, reach, slop,
                                   then);
        for (std::size_t k = 0; faced && k < faced->size(); ++k)
            (*faced)[k].normal = -(*faced)[k].normal;
    }
    if (!faced) return;
    contacts.resize(first);
    contacts.insert(contacts.end(), faced->begin(), faced->end());
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
