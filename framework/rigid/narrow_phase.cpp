// SPDX-License-Identifier: MIT
#include "rigid/narrow_phase.hpp"

#include "geometry/bounds.hpp"
#include "geometry/convex.hpp"
#include "rigid/box_box.hpp"
#include "rigid/convex_contact.hpp"
#include "rigid/core_contact.hpp"
#include "rigid/distance_field.hpp"
#include "rigid/mesh_contact.hpp"
#include "rigid/non_finite.hpp"
#include "rigid/plane_contact.hpp"

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

void touch(const PlacedSphere& sphere, const Box& box, const Pose& pose, double reach,
           Touches& touches)
{
    const Vector3d half = box.size / 2;
    const Vector3d c = pose.R.transpose() * (sphere.center - pose.X);
    const Vector3d nearest = c.cwiseMax(-half).cwiseMin(half);
    const double distance = (c - nearest).norm();

    Vector3d n = Vector3d::Zero();
    double gap = 0;
    if (distance > 0) {
        n = (c - nearest) / distance;
        gap = distance - sphere.radius;
    } else { // the center is inside: out through the nearest face
        int axis = 0;
        const double inside = (half - c.cwiseAbs()).minCoeff(&axis);
        n[axis] = c[axis] < 0 ? -1 : 1;
        gap = -inside - sphere.radius;
    }
    if (gap >= reach) return;
    n = pose.R * n;
    touches.push_back({sphere.center - sphere.radius * n, n, gap});
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

void find_ordered(const Shape& shape1, const Pose& pose1, const Shape& shape2, const Pose& pose2,
                  double reach, Counters& counters, Touches& touches)
{
    if (std::holds_alternative<Plane>(shape2))
        return touch_plane(shape1, pose1, pose2, reach, touches);
    const Box* box2 = std::get_if<Box>(&shape2);
    if (const Sphere* sphere = std::get_if<Sphere>(&shape1)) {
        const PlacedSphere placed{sphere->radius, pose1.X};
        if (const Sphere* other = std::get_if<Sphere>(&shape2))
            return touch(placed, PlacedSphere{other->radius, pose2.X}, reach, touches);
        if (box2) return touch(placed, *box2, pose2, reach, touches);
    }
    if (has_core(shape1)) return touch_core(shape1, pose1, shape2, pose2, reach, counters, touches);
    if (const Box* box1 = std::get_if<Box>(&shape1); box1 && box2)
        return touch_boxes(*box1, pose1, *box2, pose2, reach, touches);
    if (is_convex_solid(shape1) && is_convex_solid(shape2))
        return touch_convex(shape1, pose1, shape2, pose2, reach, touches);
    touch_mesh(shape1, pose1, shape2, pose2, reach, counters, touches);
}

void find_in_any_order(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                       const Pose& pose2, double reach, Counters& counters, Touches& touches)
{
    if (is_in_order(shape1, shape2))
        return find_ordered(shape1, pose1, shape2, pose2, reach, counters, touches);
    const std::size_t first = touches.size();
    find_ordered(shape2, pose2, shape1, pose1, reach, counters, touches);
    for (std::size_t i = first; i < touches.size(); ++i)
        touches[i].normal = -touches[i].normal;
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
    find_in_any_order(shape1, pose1, shape2, pose2, reach, counters, touches);
}

void find_contacts(const World& world, const std::vector<Pose>& poses, int body1, int body2,
                   double reach, std::vector<Contact>& contacts)
{
    Counters counters;
    find_contacts(world, poses, body1, body2, reach, contacts, counters);
}

void find_contacts(const World& world, const std::vector<Pose>& poses, int body1, int body2,
                   double reach, std::vector<Contact>& contacts, Counters& counters)
{
    const std::vector<Part>& parts1 = world.bodies[body1].parts;
    const std::vector<Part>& parts2 = world.bodies[body2].parts;
    const bool is_compound = parts1.size() * parts2.size() > 1;
    std::vector<Touch> touches;
    touches.reserve(4); // of two faces
    for (const Part& part1 : parts1) {
        const Pose pose1 = part_pose(poses[body1], part1);
        Bounds bounds1;
        if (is_compound) bounds1 = bounds_of(part1.shape, pose1);
        bounds1.grow(reach);
        for (const Part& part2 : parts2) {
            const Pose pose2 = part_pose(poses[body2], part2);
            if (is_compound && !bounds1.overlaps(bounds_of(part2.shape, pose2))) continue;
            try {
                find_in_any_order(part1.shape, pose1, part2.shape, pose2, reach, counters, touches);
            } catch (const NonFiniteLevelSet& e) {
                throw NonFiniteState(owner(world.bodies[body1], world.bodies[body2], e.shape),
                                     std::string(e.quantity) + " of the level set", world.time);
            }
        }
    }
    for (const Touch& found : touches)
        contacts.push_back({found, body1, body2});
}

} // namespace rigor
