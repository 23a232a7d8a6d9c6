// SPDX-License-Identifier: MIT
// Finds the contacts of two shapes. The shapes are put in a fixed order and passed to the method
// for their kinds. Two spheres, and a sphere and a box, are tested in this file; all other methods
// are in shapes/.
#include "rigid/detection/shape_contacts.hpp"

#include "geometry/distance/support.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/detection/shapes/box_box.hpp"
#include "rigid/detection/shapes/convex_contact.hpp"
#include "rigid/detection/shapes/core_contact.hpp"
#include "rigid/detection/shapes/mesh_contact.hpp"
#include "rigid/detection/shapes/plane_contact.hpp"

namespace rigor {

bool has_core(const Shape& shape)
{
    return std::holds_alternative<Sphere>(shape) || std::holds_alternative<Capsule>(shape) ||
           std::holds_alternative<Torus>(shape);
}

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
    const double slop = penetration_slop * radius;
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
// and torus come first and planes last. If not, `find_shape_contacts` exchanges the two shapes.
bool is_in_order(const Shape& a, const Shape& b)
{
    return a.index() <= b.index();
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

} // namespace

void find_shape_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                         const Pose& pose2, const Vector3d& move, double reach, Counters& counters,
                         std::vector<Contact>& contacts)
{
    if (is_in_order(shape1, shape2))
        return find_ordered(shape1, pose1, shape2, pose2, move, reach, counters, contacts);
    const std::size_t first = contacts.size();
    find_ordered(shape2, pose2, shape1, pose1, -move, reach, counters, contacts);
    for (std::size_t i = first; i < contacts.size(); ++i)
        contacts[i].normal = -contacts[i].normal;
}

void find_shape_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                         const Pose& pose2, double reach, Contacts& contacts)
{
    Counters counters;
    find_shape_contacts(shape1, pose1, shape2, pose2, {0, 0, 0}, reach, counters, contacts);
}

} // namespace rigor
