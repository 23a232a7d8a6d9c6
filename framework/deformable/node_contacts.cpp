// SPDX-License-Identifier: MIT
#include "deformable/node_contacts.hpp"

#include "formulas/collision.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "rigid/bodies/orientation.hpp"
#include "rigid/step/sleep.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

Body rigid_in_world(const World& world, const RigidBody& rigid)
{
    Body body;
    body.position = rigid.state.position;
    if (rigid.is_static) return body;
    body.inverse_mass = rigid.inverse.inverse_mass;
    body.inverse_inertia = inverse_inertia(world.settings.integrator, rigid, rigid.state);
    body.velocity = rigid.state.velocity;
    body.angular_momentum = rigid.state.angular_momentum;
    body.angular_velocity = body.inverse_inertia * rigid.state.angular_momentum;
    return body;
}

Bounds bounds_of_nodes(const Deformable& solid)
{
    Bounds bounds;
    for (const Vector3d& x : solid.positions)
        bounds.include({x, x});
    return bounds;
}

// How far a node may get towards a body within a step, and some more.
double reach_of(const Deformable& solid, const Body& body, double radius, const Vector3d& gravity,
                double time_step)
{
    double speed = 0;
    for (const Vector3d& v : solid.velocities)
        speed = std::max(speed, (v - body.velocity).norm());
    if (radius < 1e9) speed += body.angular_velocity.norm() * radius;
    return 1.5 * time_step * (speed + 2 * time_step * gravity.norm());
}

} // namespace

RigidSide::RigidSide(const World& of) : world(of), is_pushed(of.bodies.size(), 0)
{
    bodies.reserve(of.bodies.size());
    surfaces.reserve(of.bodies.size());
    for (const RigidBody& rigid : of.bodies) {
        bodies.push_back(rigid_in_world(of, rigid));
        surfaces.push_back(
            {body_rotation(of.settings.integrator, rigid.state), rigid.state.position});
    }
}

void RigidSide::advance(double time_step)
{
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].is_static()) continue;
        const Vector3d turn = time_step * bodies[i].angular_velocity;
        const double angle = turn.norm();
        surfaces[i].X += time_step * bodies[i].velocity;
        if (angle > 0) surfaces[i].R = Eigen::AngleAxisd(angle, turn / angle) * surfaces[i].R;
    }
}

void RigidSide::push(int body, const Vector3d& point, const Vector3d& impulse)
{
    if (bodies[body].is_static()) return;
    bodies[body] = apply_impulse(bodies[body], point, impulse);
    is_pushed[body] = 1;
}

bool RigidSide::rests(int body) const
{
    return world.bodies[body].rest.is_asleep() ||
           std::any_of(world.memory.warm_contacts.begin(), world.memory.warm_contacts.end(),
                       [&](const WarmContact& c) { return c.body1 == body || c.body2 == body; });
}

void RigidSide::give_back(World& to, double time_step) const
{
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!is_pushed[i]) continue;
        if (to.bodies[i].rest.is_asleep()) wake(to, {static_cast<int>(i)});
        // Its flight will add h V + ½ g h². Held by nodes it does not fly, but drifts with the velocity
        // that it has in the end, V + g h.
        if (!rests(static_cast<int>(i)))
            to.bodies[i].state.position += 0.5 * time_step * time_step * to.settings.gravity;
        to.bodies[i].state.velocity = bodies[i].velocity;
        to.bodies[i].state.angular_momentum = bodies[i].angular_momentum;
    }
}

void NodeContacts::find(const Deformable& solid, const std::vector<char>& is_surface,
                        const RigidSide& rigid, double time_step, Counters& counters)
{
    parts_.clear();
    contacts_.clear();
    if (rigid.bodies.empty()) return;
    const Bounds bounds = bounds_of_nodes(solid);
    for (int b = 0; b < static_cast<int>(rigid.bodies.size()); ++b) {
        const RigidBody& body = rigid.world.bodies[b];
        const Material &m1 = solid.material.surface, &m2 = body.material;
        for (const Part& part : body.parts) {
            const Pose pose = part_pose(rigid.surfaces[b], part);
            const double reach = reach_of(solid, rigid.bodies[b], bounding_radius(part),
                                          rigid.world.settings.gravity, time_step);
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
                contacts_.push_back({i, b, number, 0, Vector3d::UnitY(),
                                     std::min(m1.restitution, m2.restitution),
                                     std::sqrt(m1.friction * m2.friction)});
            }
        }
    }
}

void NodeContacts::measure(const Deformable& solid, const RigidSide& rigid)
{
    for (NodeContact& c : contacts_) {
        const NearPart& part = parts_[c.part];
        const Pose pose = rigid.surfaces[c.body] * part.in_body;
        const Vector3d p = pose.R.transpose() * (solid.positions[c.node] - pose.X);
        c.gap = part.field.distance(p);
        c.normal = pose.R * part.field.normal(p);
    }
}

Body node_body(const Deformable& solid, int node, double inverse_mass)
{
    Body body;
    body.inverse_mass = inverse_mass;
    body.position = solid.positions[node];
    body.velocity = solid.velocities[node];
    return body;
}

void collide_nodes(Deformable& solid, const std::vector<char>& is_held,
                   const NodeContacts& contacts, RigidSide& rigid, double time_step,
                   bool with_restitution, Counters& counters)
{
    const double weak =
        2 * time_step * rigid.world.settings.gravity.norm(); // speeds that gravity undoes at once
    for (const NodeContact& c : contacts.all()) {
        const Vector3d x = solid.positions[c.node], n = c.normal;
        const double inverse_mass = is_held[c.node] ? 0 : 1 / solid.masses[c.node];
        const Body& body = rigid.bodies[c.body];
        if (inverse_mass == 0 && body.is_static()) continue;
        const Vector3d v = relative_velocity(node_body(solid, c.node, inverse_mass), body, x);
        const double v_n = v.dot(n);
        if (v_n >= 0 || c.gap + time_step * v_n >= 0) continue;
        if (with_restitution && (c.restitution == 0 || -c.restitution * v_n < weak)) continue;
        const Matrix3d K =
            inverse_mass * Matrix3d::Identity() +
            impulse_matrix(body.inverse_mass, body.inverse_inertia, body.position, x);
        // without restitution: as if a gap that closes within the step were an approach less
        const Vector3d closing = with_restitution ? v : v + std::max(c.gap, 0.0) / time_step * n;
        const Vector3d j =
            collision_impulse(K, closing, n, with_restitution ? c.restitution : 0.0, c.friction);
        solid.velocities[c.node] += inverse_mass * j;
        rigid.push(c.body, x, -j);
        ++counters.node_impulses;
    }
}

void heal_nodes(Deformable& solid, const std::vector<char>& is_held, const NodeContacts& contacts,
                double step_share, double farthest)
{
    for (const NodeContact& c : contacts.all()) {
        if (c.gap >= 0 || is_held[c.node]) continue;
        solid.positions[c.node] += std::min(0.2 * step_share * -c.gap, farthest) * c.normal;
    }
}

} // namespace rigor
