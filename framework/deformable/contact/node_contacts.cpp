// SPDX-License-Identifier: MIT
// Finds the nodes that may touch rigid bodies within a step. Bounding boxes select the parts of
// bodies near the solid and the nodes near each part; signed distances then select the nodes that
// the part may reach.
#include "deformable/contact/node_contacts.hpp"

#include "geometry/bounds/bounds.hpp"
#include "geometry/shapes/shape_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

Bounds bounds_of_nodes(const Deformable& solid)
{
    Bounds bounds;
    for (const Vector3d& x : solid.positions)
        bounds.include({x, x});
    return bounds;
}

// An estimate of the largest distance by which a node can approach a body within a step [m].
double reach_of(const Deformable& solid, const RigidColliders& rigid, int body, double radius,
                double time_step)
{
    // This factor enlarges the result, because nodes may get faster within the step. Its value was
    // chosen by trial.
    constexpr double for_acceleration = 1.5;
    // Above this radius [m] the rotation of the body is left out. A body with a plane does not
    // rotate, but its radius is infinite, and 0 times infinity is NaN.
    constexpr double unbounded = 1e9;
    const Vector3d V = rigid.velocity_of(body);
    double speed = 0;
    for (const Vector3d& v : solid.velocities)
        speed = std::max(speed, (v - V).norm());
    if (radius < unbounded) speed += rigid.mover(body).body.angular_velocity.norm() * radius;
    const double fall = std::max(time_step * rigid.world.settings.gravity.norm(),
                                 time_step * rigid.mover(body).acceleration.norm());
    return for_acceleration * time_step * (speed + 2 * fall);
}

} // namespace

void NodeContacts::find(const Deformable& solid, const std::vector<char>& is_surface,
                        const RigidColliders& rigid, double time_step, Counters& counters)
{
    parts_.clear();
    contacts_.clear();
    if (rigid.surfaces.empty()) return;
    const Bounds bounds = bounds_of_nodes(solid);
    for (int b = 0; b < static_cast<int>(rigid.surfaces.size()); ++b) {
        const RigidBody& body = rigid.world.bodies[b];
        const Material both = combined(solid.material.surface, body.material);
        for (const Part& part : body.parts) {
            const Pose pose = part_pose(rigid.surfaces[b], part);
            const double reach = reach_of(solid, rigid, b, bounding_radius(part), time_step);
            Bounds near = bounds_of(part.shape, pose);
            near.grow(reach);
            if (!near.overlaps(bounds)) continue;
            const int number = static_cast<int>(parts_.size());
            parts_.push_back({b, part_pose({}, part), DistanceField(part.shape, counters)});
            const DistanceField& field = parts_.back().field;
            for (int i = 0; i < static_cast<int>(is_surface.size()); ++i) {
                const Vector3d& x = solid.positions[i];
                if (!is_surface[i] || !near.overlaps({x, x})) continue;
                const Vector3d p = pose.R.transpose() * (x - pose.X);
                if (field.at_least(p) > reach || field.distance(p) > reach) continue;
                contacts_.push_back(
                    {i, b, number, 0, Vector3d::UnitY(), both.restitution, both.friction});
            }
        }
    }
}

void NodeContacts::measure(const Deformable& solid, const RigidColliders& rigid)
{
    for (NodeContact& c : contacts_) {
        const NearPart& part = parts_[c.part];
        const Pose pose = rigid.surfaces[c.body] * part.in_body;
        const Vector3d p = pose.R.transpose() * (solid.positions[c.node] - pose.X);
        c.gap = part.field.distance(p);
        c.normal = pose.R * part.field.normal(p);
    }
}

} // namespace rigor
