// SPDX-License-Identifier: MIT
#include "rigid/narrow_phase.hpp"

#include "geometry/distance/support.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "rigid/box_box.hpp"
#include "rigid/convex_contact.hpp"
#include "rigid/core_contact.hpp"
#include "rigid/distance_field.hpp"
#include "rigid/from_lowest.hpp"
#include "rigid/mesh_contact.hpp"
#include "rigid/non_finite.hpp"
#include "rigid/plane_contact.hpp"

#include <algorithm>

namespace rigor {

namespace {

struct PlacedSphere {
    double radius;
    Vector3d center;
};

using Touches = std::vector<Touch>;

void touch(const PlacedSphere& a, const PlacedSphere& b, double reach, Touches& touches)
{
    const Vector3d d = a.center - b.center;
    const double distance = d.norm();
    const double gap = distance - a.radius - b.radius;
    if (gap >= reach) return;
    const Vector3d n = distance > 0 ? Vector3d(d / distance) : Vector3d::UnitY(); // concentric: up
    touches.push_back({b.center + (b.radius + gap / 2) * n, n, gap});
}

// Out of a box, from the point of it that is nearest to a sphere: normal, and distance from there.
struct OutOfBox {
    Vector3d n = Vector3d::Zero();
    double gap = 0;
    bool is_inside = false; // the sphere's center is: out through the nearest face
};

// @param c  the sphere's center, in the frame of the box
OutOfBox out_of_box(const Vector3d& half, const Vector3d& c, double radius)
{
    OutOfBox out;
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

// A normal along which a sphere at c and a box are apart now, and how far they will be after the move d.
struct ApartAhead {
    Vector3d n;
    double now, then;
};

// Of the normal at the move's end, if they do not meet there, and those of the faces: the one that has them
// overlap least then. So a sphere that rolls over the joint of two boxes, or falls there, doesn't run into
// the edge of the next.
void look_ahead(const Vector3d& half, const Vector3d& c, const Vector3d& d, double radius,
                ApartAhead& best)
{
    constexpr double slop = 1e-4; // of the radius
    const auto consider = [&](const Vector3d& n) {
        const double now = n.dot(c) - n.cwiseAbs().dot(half) - radius, then = now + n.dot(d);
        if (now > -slop * radius && then > best.then) best = {n, now, then};
    };
    for (int i = 0; i < 3; ++i)
        consider((c[i] < 0 ? -1 : 1) * Vector3d::Unit(i));
    const OutOfBox end = out_of_box(half, c + d, radius);
    if (!end.is_inside && end.gap > -slop * radius) consider(end.n);
}

void touch(const PlacedSphere& sphere, const Box& box, const Pose& pose, const Vector3d& move,
           double reach, Touches& touches)
{
    const Vector3d half = box.size / 2;
    const Vector3d c = pose.R.transpose() * (sphere.center - pose.X);
    const OutOfBox out = out_of_box(half, c, sphere.radius);
    if (out.gap >= reach) return;
    const Vector3d d = pose.R.transpose() * move;
    ApartAhead best{out.n, out.gap, out.gap + d.dot(out.n)};
    if (!out.is_inside && best.then < 0) look_ahead(half, c, d, sphere.radius, best);
    const Vector3d n = pose.R * best.n;
    touches.push_back({sphere.center - sphere.radius * n, n, best.now});
}

// In the order of the variant, with what has a core first and planes last: half of the pairs are the other
// half, seen from the other side.
bool is_in_order(const Shape& a, const Shape& b)
{
    return a.index() <= b.index();
}

bool has_core(const Shape& shape)
{
    return std::holds_alternative<Sphere>(shape) || std::holds_alternative<Capsule>(shape) ||
           std::holds_alternative<Torus>(shape);
}

// @param move  of shape 1, against shape 2, in the step to come
void find_ordered(const Shape& shape1, const Pose& pose1, const Shape& shape2, const Pose& pose2,
                  const Vector3d& move, double reach, Counters& counters, Touches& touches)
{
    if (std::holds_alternative<Plane>(shape2))
        return touch_plane(shape1, pose1, pose2, reach, touches);
    const Box* box2 = std::get_if<Box>(&shape2);
    if (const Sphere* sphere = std::get_if<Sphere>(&shape1)) {
        const PlacedSphere placed{sphere->radius, pose1.X};
        if (const Sphere* other = std::get_if<Sphere>(&shape2))
            return touch(placed, PlacedSphere{other->radius, pose2.X}, reach, touches);
        if (box2) return touch(placed, *box2, pose2, move, reach, touches);
    }
    if (has_core(shape1)) return touch_core(shape1, pose1, shape2, pose2, reach, counters, touches);
    if (const Box* box1 = std::get_if<Box>(&shape1); box1 && box2)
        return touch_boxes(*box1, pose1, *box2, pose2, move, reach, touches);
    if (is_convex_solid(shape1) && is_convex_solid(shape2))
        return touch_convex(shape1, pose1, shape2, pose2, reach, touches);
    touch_mesh(shape1, pose1, shape2, pose2, reach, counters, touches);
}

void find_in_any_order(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                       const Pose& pose2, const Vector3d& move, double reach, Counters& counters,
                       Touches& touches)
{
    if (is_in_order(shape1, shape2))
        return find_ordered(shape1, pose1, shape2, pose2, move, reach, counters, touches);
    const std::size_t first = touches.size();
    find_ordered(shape2, pose2, shape1, pose1, -move, reach, counters, touches);
    for (std::size_t i = first; i < touches.size(); ++i)
        touches[i].normal = -touches[i].normal;
}

Vector3d velocity_of(const RigidBody& body)
{
    return body.is_still() ? Vector3d(0, 0, 0) : body.state.velocity;
}

// The body that has the shape: its level set was asked.
const std::string& owner(const RigidBody& body1, const RigidBody& body2, const Shape* shape)
{
    for (const Part& part : body1.parts)
        if (&part.shape == shape) return body1.name;
    return body2.name;
}

} // namespace

void find_touches(const Shape& shape1, const Pose& pose1, const Shape& shape2, const Pose& pose2,
                  double reach, Touches& touches)
{
    Counters counters;
    find_in_any_order(shape1, pose1, shape2, pose2, {0, 0, 0}, reach, counters, touches);
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
    const Vector3d move =
        time_step * (velocity_of(world.bodies[body1]) - velocity_of(world.bodies[body2]));
    const std::vector<Part>& parts1 = world.bodies[body1].parts;
    const std::vector<Part>& parts2 = world.bodies[body2].parts;
    const bool is_compound = parts1.size() * parts2.size() > 1;
    std::vector<Touch> touches;
    touches.reserve(8); // of two faces
    for (const Part& part1 : parts1) {
        const Pose pose1 = part_pose(poses[body1], part1);
        Bounds bounds1;
        if (is_compound) bounds1 = bounds_of(part1.shape, pose1);
        bounds1.grow(reach);
        for (const Part& part2 : parts2) {
            const Pose pose2 = part_pose(poses[body2], part2);
            if (is_compound && !bounds1.overlaps(bounds_of(part2.shape, pose2))) continue;
            try {
                find_in_any_order(part1.shape, pose1, part2.shape, pose2, move, reach, counters,
                                  touches);
            } catch (const NonFiniteLevelSet& e) {
                throw NonFiniteState(owner(world.bodies[body1], world.bodies[body2], e.shape),
                                     std::string(e.quantity) + " of the level set", world.time);
            }
        }
    }
    if (touches.size() > 1) {
        const FromLowest place_of(world.gravity, touches,
                                  [](const Touch& t) -> const Vector3d& { return t.point; });
        std::sort(touches.begin(), touches.end(), [&](const Touch& a, const Touch& b) {
            return place_of(a.point) < place_of(b.point);
        });
    }
    for (const Touch& found : touches)
        contacts.push_back({found, body1, body2});
}

} // namespace rigor
