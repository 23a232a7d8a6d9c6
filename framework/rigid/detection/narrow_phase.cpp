// SPDX-License-Identifier: MIT
// The narrow phase: finds the contacts of two bodies, part by part. Each pair of shapes is put in a
// fixed order and passed to the method for its kinds of shapes. Two spheres, and a sphere and a
// box, are tested in this file; all other methods are in shapes/. Last, the contacts are sorted by
// height.
#include "rigid/detection/narrow_phase.hpp"

#include "geometry/distance/support.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/bodies/height_order.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "rigid/detection/shapes/box_box.hpp"
#include "rigid/detection/shapes/convex_contact.hpp"
#include "rigid/detection/shapes/core_contact.hpp"
#include "rigid/detection/shapes/distance_field.hpp"
#include "rigid/detection/shapes/mesh_contact.hpp"
#include "rigid/detection/shapes/plane_contact.hpp"

#include <algorithm>
#include <span>

namespace rigor {

namespace {

struct PlacedSphere {
    double radius;
    Vector3d center;
};

using Contacts = std::vector<Contact>;

void find_sphere_contacts(const PlacedSphere& a, const PlacedSphere& b, double reach,
                          Contacts& contacts)
{
    const Vector3d d = a.center - b.center;
    const double distance = d.norm();
    const double gap = distance - a.radius - b.radius;
    if (gap >= reach) return;
    // If both centers are equal, the normal is the y axis.
    const Vector3d n = distance > 0 ? Vector3d(d / distance) : Vector3d::UnitY();
    contacts.push_back({b.center + (b.radius + gap / 2) * n, n, gap});
}

// A sphere and a box, in the frame of the box: the normal at the point of the box that is nearest
// to the sphere, and the gap along this normal.
struct SphereBoxGap {
    Vector3d n = Vector3d::Zero();
    double gap = 0;
    bool is_inside = false; // the sphere's center is in the box; n: the normal of the nearest face
};

// @param c  the sphere's center in the frame of the box
SphereBoxGap sphere_box_gap(const Vector3d& half, const Vector3d& c, double radius)
{
    SphereBoxGap out;
    const Vector3d nearest = c.cwiseMax(-half).cwiseMin(half);
    const double distance = (c - nearest).norm();
    if (distance > 0) {
        out.n = (c - nearest) / distance;
        out.gap = distance - radius;
        return out;
    }
    int axis = 0;
    const double inside = (half - c.cwiseAbs()).minCoeff(&axis);
    out.n[axis] = c[axis] < 0 ? -1 : 1;
    out.gap = -inside - radius;
    out.is_inside = true;
    return out;
}

// A normal between a sphere and a box, and the distance of the two along this normal, now and after
// the move of the sphere [m]. Negative distances are overlaps.
struct NormalAhead {
    Vector3d n;
    double now, then;
};

// Replaces `best` by the normal along which the sphere at c and the box overlap least after the
// move d of the sphere. Only normals are considered along which the two shapes are apart now or
// overlap by less than the slop. These are the normals of the faces and, if the shapes do not
// overlap by more than the slop after the move, their contact normal after the move. So a sphere
// that rolls over the joint between two boxes, or falls onto it, does not run into the edge of the
// second box.
void improve_by_looking_ahead(const Vector3d& half, const Vector3d& c, const Vector3d& d,
                              double radius, NormalAhead& best)
{
    const double slop = resting_overlap * radius;
    const auto consider = [&](const Vector3d& n) {
        const double now = n.dot(c) - n.cwiseAbs().dot(half) - radius, then = now + n.dot(d);
        if (now > -slop && then > best.then) best = {n, now, then};
    };
    for (int i = 0; i < 3; ++i)
        consider((c[i] < 0 ? -1 : 1) * Vector3d::Unit(i));
    const SphereBoxGap end = sphere_box_gap(half, c + d, radius);
    if (!end.is_inside && end.gap > -slop) consider(end.n);
}

void find_sphere_contacts(const PlacedSphere& sphere, const Box& box, const Pose& pose,
                          const Vector3d& move, double reach, Contacts& contacts)
{
    const Vector3d half = box.size / 2;
    const Vector3d c = pose.R.transpose() * (sphere.center - pose.X);
    const SphereBoxGap out = sphere_box_gap(half, c, sphere.radius);
    if (out.gap >= reach) return;
    const Vector3d d = pose.R.transpose() * move;
    NormalAhead best{out.n, out.gap, out.gap + d.dot(out.n)};
    if (!out.is_inside && best.then < 0) improve_by_looking_ahead(half, c, d, sphere.radius, best);
    const Vector3d n = pose.R * best.n;
    contacts.push_back({sphere.center - sphere.radius * n, n, best.now});
}

// Whether the shapes are in the order of the types in the variant `Shape`, where sphere, capsule
// and torus come first and planes last. If not, `find_in_any_order` exchanges the two shapes.
bool is_in_order(const Shape& a, const Shape& b)
{
    return a.index() <= b.index();
}

bool has_core(const Shape& shape)
{
    return std::holds_alternative<Sphere>(shape) || std::holds_alternative<Capsule>(shape) ||
           std::holds_alternative<Torus>(shape);
}

// @param move  displacement of shape 1 relative to shape 2 in this step
void find_ordered(const Shape& shape1, const Pose& pose1, const Shape& shape2, const Pose& pose2,
                  const Vector3d& move, double reach, Counters& counters, Contacts& contacts)
{
    if (std::holds_alternative<Plane>(shape2))
        return find_plane_contacts(shape1, pose1, pose2, reach, contacts);
    const Box* box2 = std::get_if<Box>(&shape2);
    if (const Sphere* sphere = std::get_if<Sphere>(&shape1)) {
        const PlacedSphere placed{sphere->radius, pose1.X};
        if (const Sphere* other = std::get_if<Sphere>(&shape2))
            return find_sphere_contacts(placed, PlacedSphere{other->radius, pose2.X}, reach,
                                        contacts);
        if (box2) return find_sphere_contacts(placed, *box2, pose2, move, reach, contacts);
    }
    if (has_core(shape1))
        return find_core_contacts(shape1, pose1, shape2, pose2, reach, counters, contacts);
    if (const Box* box1 = std::get_if<Box>(&shape1); box1 && box2)
        return find_box_contacts(*box1, pose1, *box2, pose2, move, reach, contacts);
    if (is_convex_solid(shape1) && is_convex_solid(shape2))
        return find_convex_contacts(shape1, pose1, shape2, pose2, reach, contacts);
    find_mesh_contacts(shape1, pose1, shape2, pose2, reach, counters, contacts);
}

void find_in_any_order(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                       const Pose& pose2, const Vector3d& move, double reach, Counters& counters,
                       Contacts& contacts)
{
    if (is_in_order(shape1, shape2))
        return find_ordered(shape1, pose1, shape2, pose2, move, reach, counters, contacts);
    const std::size_t first = contacts.size();
    find_ordered(shape2, pose2, shape1, pose1, -move, reach, counters, contacts);
    for (std::size_t i = first; i < contacts.size(); ++i)
        contacts[i].normal = -contacts[i].normal;
}

void sort_by_height(const Vector3d& gravity, std::span<Contact> contacts)
{
    const HeightOrder key_of(gravity, contacts,
                             [](const Contact& t) -> const Vector3d& { return t.point; });
    std::sort(contacts.begin(), contacts.end(), [&](const Contact& a, const Contact& b) {
        return key_of(a.point) < key_of(b.point);
    });
}

Vector3d velocity_of(const RigidBody& body)
{
    return body.is_still() ? Vector3d(0, 0, 0) : body.state.velocity;
}

bool is_concave(const Shape& shape)
{
    const Mesh* mesh = std::get_if<Mesh>(&shape);
    return mesh && !mesh->solid->is_convex();
}

// Whether each of two bodies is still, and the displacement of body 1 relative to body 2 that their
// velocities give in this step.
struct MovingPair {
    bool is_still1 = false, is_still2 = false;
    Vector3d move = Vector3d::Zero();

    // Whether the search for contacts ahead is worth its time: one of the shapes is concave, and
    // either its body is still, or the other shape has a core, so that the search is cheap.
    bool looks_ahead(const Shape& shape1, const Shape& shape2) const
    {
        if (is_concave(shape1) && (is_still1 || has_core(shape2))) return true;
        return is_concave(shape2) && (is_still2 || has_core(shape1));
    }
    // The share of `move` by which a contact point moves relative to body 2. If only one body
    // moves, the point moves with this body. If both move, the share is one half.
    double point_share() const { return is_still2 ? 1 : is_still1 ? 0 : 0.5; }
};

// Appends the contacts with the part of a concave shape that another shape reaches in this step, as
// in a bowl, where the wall ahead is steeper than the wall below. Such a contact is found with
// shape 1 after its move relative to shape 2, and its gap is measured along the same normal before
// the move. The contact is kept under three conditions: the shapes would overlap there after the
// move, they do not overlap there now by more than the slop, and they have no other contact with
// this normal. Without such contacts, a shape would move into the wall, and the position correction
// would lift the shape, which adds energy.
//
// @param first  the contacts of these two shapes start at this index
void find_contacts_ahead(const Shape& shape1, const Pose& pose1, const Shape& shape2,
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
    const Bounds bounds1 = bounds_of(shape1, {}), bounds2 = bounds_of(shape2, {});
    const double size =
        std::min((bounds1.high - bounds1.low).norm(), (bounds2.high - bounds2.low).norm());
    const double slop = resting_overlap * size / 2;
    if (way < slop) return;
    Contacts ahead;
    find_in_any_order(shape1, {pose1.R, pose1.X + pair.move}, shape2, pose2, {0, 0, 0}, overlapping,
                      counters, ahead);
    for (const Contact& c : ahead) {
        const double now = c.gap - c.normal.dot(pair.move);
        if (now < -slop || any_known([&](const Contact& known) {
                return (known.normal - c.normal).norm() < same_normal;
            }))
            continue;
        contacts.push_back({c.point - pair.point_share() * pair.move, c.normal, now});
    }
}

// The name of the body to which the shape belongs.
const std::string& owner(const RigidBody& body1, const RigidBody& body2, const Shape* shape)
{
    for (const Part& part : body1.parts)
        if (&part.shape == shape) return body1.name;
    return body2.name;
}

} // namespace

void find_shape_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                         const Pose& pose2, double reach, Contacts& contacts)
{
    Counters counters;
    find_in_any_order(shape1, pose1, shape2, pose2, {0, 0, 0}, reach, counters, contacts);
}

void find_contacts(const World& world, const std::vector<Pose>& poses, int body1, int body2,
                   double reach, std::vector<Contact>& contacts)
{
    Counters counters;
    find_contacts(world, poses, body1, body2, reach, contacts, counters);
}

void find_contacts(const World& world, const std::vector<Pose>& poses, int body1, int body2,
                   double reach, std::vector<Contact>& contacts, Counters& counters,
                   double time_step)
{
    const RigidBody &first_body = world.bodies[body1], &second_body = world.bodies[body2];
    const MovingPair pair{first_body.is_still(), second_body.is_still(),
                          time_step * (velocity_of(first_body) - velocity_of(second_body))};
    const std::vector<Part>& parts1 = world.bodies[body1].parts;
    const std::vector<Part>& parts2 = world.bodies[body2].parts;
    const bool is_compound = parts1.size() * parts2.size() > 1;
    const std::size_t first = contacts.size();
    for (const Part& part1 : parts1) {
        const Pose pose1 = part_pose(poses[body1], part1);
        Bounds bounds1;
        if (is_compound) bounds1 = bounds_of(part1.shape, pose1);
        bounds1.grow(reach);
        for (const Part& part2 : parts2) {
            const Pose pose2 = part_pose(poses[body2], part2);
            if (is_compound && !bounds1.overlaps(bounds_of(part2.shape, pose2))) continue;
            try {
                const std::size_t first_of_parts = contacts.size();
                find_in_any_order(part1.shape, pose1, part2.shape, pose2, pair.move, reach,
                                  counters, contacts);
                if (pair.looks_ahead(part1.shape, part2.shape))
                    find_contacts_ahead(part1.shape, pose1, part2.shape, pose2, pair, counters,
                                        first_of_parts, contacts);
            } catch (const NonFiniteLevelSet& e) {
                throw NonFiniteState(owner(world.bodies[body1], world.bodies[body2], e.shape),
                                     std::string(e.quantity) + " of the level set", world.time);
            }
        }
    }
    const std::span<Contact> found = std::span(contacts).subspan(first);
    for (Contact& contact : found) {
        contact.body1 = body1;
        contact.body2 = body2;
    }
    if (found.size() > 1) sort_by_height(world.settings.gravity, found);
}

} // namespace rigor
