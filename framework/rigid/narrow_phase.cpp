// SPDX-License-Identifier: MIT
#include "rigid/narrow_phase.hpp"

#include "geometry/bounds.hpp"
#include "rigid/box_box.hpp"

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

void touch(const PlacedSphere& sphere, const Pose& plane, double reach, Touches& touches)
{
    const Vector3d n = plane.R.col(1);
    const double gap = n.dot(sphere.center - plane.X) - sphere.radius;
    if (gap < reach) touches.push_back({sphere.center - sphere.radius * n, n, gap});
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

void touch(const Box& box, const Pose& pose, const Pose& plane, double reach, Touches& touches)
{
    const Vector3d n = plane.R.col(1);
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const Vector3d x = pose * sign.cwiseProduct(box.size / 2);
        const double gap = n.dot(x - plane.X);
        if (gap < reach) touches.push_back({x, n, gap});
    }
}

// Spheres before boxes before planes: half of the pairs are the other half, seen from the other side.
bool is_in_order(const Shape& a, const Shape& b)
{
    return a.index() <= b.index();
}

void find_ordered(const Shape& shape1, const Pose& pose1, const Shape& shape2, const Pose& pose2,
                  double reach, Touches& touches)
{
    const Box* box1 = std::get_if<Box>(&shape1);
    const Box* box2 = std::get_if<Box>(&shape2);
    const bool is_plane2 = std::holds_alternative<Plane>(shape2);
    if (const Sphere* sphere = std::get_if<Sphere>(&shape1)) {
        const PlacedSphere placed{sphere->radius, pose1.X};
        if (const Sphere* other = std::get_if<Sphere>(&shape2))
            touch(placed, PlacedSphere{other->radius, pose2.X}, reach, touches);
        if (box2) touch(placed, *box2, pose2, reach, touches);
        if (is_plane2) touch(placed, pose2, reach, touches);
    } else if (box1 && box2) {
        touch_boxes(*box1, pose1, *box2, pose2, reach, touches);
    } else if (box1 && is_plane2) {
        touch(*box1, pose1, pose2, reach, touches);
    }
}

} // namespace

void find_touches(const Shape& shape1, const Pose& pose1, const Shape& shape2, const Pose& pose2,
                  double reach, Touches& touches)
{
    if (is_in_order(shape1, shape2))
        return find_ordered(shape1, pose1, shape2, pose2, reach, touches);
    const std::size_t first = touches.size();
    find_ordered(shape2, pose2, shape1, pose1, reach, touches);
    for (std::size_t i = first; i < touches.size(); ++i)
        touches[i].normal = -touches[i].normal;
}

void find_contacts(const World& world, const std::vector<Pose>& poses, int body1, int body2,
                   double reach, std::vector<Contact>& contacts)
{
    const std::vector<Part>& parts1 = world.bodies[body1].parts;
    const std::vector<Part>& parts2 = world.bodies[body2].parts;
    const bool is_compound = parts1.size() * parts2.size() > 1;
    std::vector<Touch> touches;
    for (const Part& part1 : parts1) {
        const Pose pose1 = part_pose(poses[body1], part1);
        Bounds bounds1 = bounds_of(part1.shape, pose1);
        bounds1.grow(reach);
        for (const Part& part2 : parts2) {
            const Pose pose2 = part_pose(poses[body2], part2);
            if (is_compound && !bounds1.overlaps(bounds_of(part2.shape, pose2))) continue;
            find_touches(part1.shape, pose1, part2.shape, pose2, reach, touches);
        }
    }
    for (const Touch& found : touches)
        contacts.push_back({found, body1, body2});
}

} // namespace rigor
