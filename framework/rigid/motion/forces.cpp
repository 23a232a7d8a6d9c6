// SPDX-License-Identifier: MIT
// Wrenches of gravity, springs, applied forces and drag at one time. First the motion of each body
// and of the points of attachment is computed, then the point forces on each body are collected,
// and last `net_wrench` adds them up.
#include "rigid/motion/forces.hpp"

#include "formulas/kinematics.hpp"
#include "formulas/rotation.hpp"
#include "rigid/bodies/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

bool acts(const AppliedForce& force, double time)
{
    return force.start <= time && time < force.end;
}

// One end of a spring in world space: its position x [m] and, if the spring has damping, its
// velocity v [m/s].
struct SpringEnd {
    Vector3d x = Vector3d::Zero(), v = Vector3d::Zero();
};

SpringEnd spring_end(int body, const Vector3d& point, bool damps, std::span<const Motion> motions)
{
    if (body < 0) return {point, Vector3d::Zero()};
    const Motion& m = motions[body];
    SpringEnd end;
    end.x = world_point(m.R, m.X, point);
    if (damps) end.v = point_velocity(m.V, m.omega, m.X, end.x);
    return end;
}

// @param needs_omega  whether any force depends on velocities; otherwise ω stays zero
Motion motion_of(Integrator integrator, const RigidBody& body, const RigidState& state,
                 bool needs_omega)
{
    Motion m{body_rotation(integrator, state), state.position, state.velocity, Vector3d::Zero()};
    if (needs_omega) m.omega = angular_velocity(integrator, body, state);
    return m;
}

} // namespace

std::vector<bool> pulled_bodies(const World& world, double time_step)
{
    std::vector<bool> pulled(world.bodies.size(), false);
    for (const Spring& spring : world.springs)
        for (int body : {spring.body1, spring.body2})
            if (body >= 0 && !world.bodies[body].is_static) pulled[body] = true;
    for (const AppliedForce& force : world.forces)
        if (force.start <= world.time + time_step && world.time < force.end)
            if (!world.bodies[force.body].is_static) pulled[force.body] = true;
    return pulled;
}

std::vector<bool> with_dragged_bodies(std::vector<bool> pulled, const World& world)
{
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
        if (world.bodies[i].drag.acts() && !world.bodies[i].is_static &&
            !world.bodies[i].rest.is_asleep())
            pulled[i] = true;
    return pulled;
}

ForceRate fastest_force_rate(const World& world)
{
    const auto compliance = [&](int body, const Vector3d& r) -> double {
        if (body < 0 || world.bodies[body].is_static) return 0;
        const BodyInertia& inverse = world.bodies[body].inverse;
        return inverse.inverse_mass + r.squaredNorm() * inverse.inverse_inertia.norm();
    };
    // Σ k K and Σ c K over the springs of each body (k: stiffness, c: damping, K: the sum of the
    // compliances at both ends of a spring).
    std::vector<double> stiffness(world.bodies.size(), 0), damping = stiffness;
    for (const Spring& spring : world.springs) {
        const double K =
            compliance(spring.body1, spring.point1) + compliance(spring.body2, spring.point2);
        for (int body : {spring.body1, spring.body2}) {
            if (body < 0 || world.bodies[body].is_static) continue;
            stiffness[body] += std::abs(spring.stiffness) * K;
            damping[body] += std::abs(spring.damping) * K;
        }
    }
    ForceRate fastest;
    const auto consider = [&](double rate, int body) {
        if (rate > fastest.rate) fastest = {rate, body};
    };
    for (const AppliedForce& force : world.forces)
        consider(2 * std::numbers::pi * force.frequency, force.body);
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const RigidBody& body = world.bodies[i];
        const auto& [c, k, d] = body.drag;
        if (!body.drag.acts() || body.is_static) continue;
        // The derivative of the drag c v + k v² is c + 2 k v.
        consider(std::max((c + 2 * k * body.state.velocity.norm()) * body.inverse.inverse_mass,
                          d * body.inverse.inverse_inertia.norm()),
                 static_cast<int>(i));
    }
    for (std::size_t i = 0; i < stiffness.size(); ++i)
        consider(std::max(std::sqrt(stiffness[i]), damping[i]), static_cast<int>(i));
    return fastest;
}

Wrench gravity_on(const Settings& settings, const RigidBody& body, const Vector3d& X)
{
    const Vector3d& g = settings.gravity;
    if (g.isZero(0)) return {};
    if (settings.integrator == Integrator::matrix) return net_wrench({{body.mass * g, X}}, X);
    return gravity_wrench(body.mass, g);
}

AppliedWrenches::AppliedWrenches(const World& world, std::span<const int> bodies,
                                 std::span<const Wrench> supports)
    : world_(world), bodies_(bodies), supports_(supports),
      depends_on_velocities_(
          std::any_of(world.springs.begin(), world.springs.end(),
                      [](const Spring& spring) { return spring.damping != 0; }) ||
          std::any_of(bodies.begin(), bodies.end(),
                      [&](int i) { return world.bodies[i].drag.acts(); })),
      motions_(world.bodies.size()), forces_(world.bodies.size()),
      torques_(world.bodies.size(), Vector3d::Zero()), net_(bodies.size())
{
    for (const Spring& spring : world.springs)
        for (int i : {spring.body1, spring.body2})
            if (i >= 0 && world.bodies[i].changes_place()) {
                driven_.push_back(i);
            } else if (i >= 0 && world.bodies[i].is_static) {
                const RigidBody& body = world.bodies[i];
                motions_[i] = motion_of(world.settings.integrator, body, body.state, false);
            }
}

void AppliedWrenches::push(int body, const Vector3d& force, const Vector3d& point)
{
    if (body >= 0 && !world_.bodies[body].is_static) forces_[body].push_back({force, point});
}

void AppliedWrenches::add_spring(const Spring& spring)
{
    const bool damps = spring.damping != 0;
    const SpringEnd end1 = spring_end(spring.body1, spring.point1, damps, motions_);
    const SpringEnd end2 = spring_end(spring.body2, spring.point2, damps, motions_);
    const Vector3d d = end2.x - end1.x;
    const double length = d.norm();
    if (length == 0) return; // the force of the spring has no direction
    if (spring.only_pulls && length <= spring.rest_length) return;

    // f₁ = (k (|d| - l₀) + c (v₂ - v₁)·u) u,  u = d/|d|,  f₂ = -f₁
    const Vector3d u = d / length;
    double tension = spring.stiffness * (length - spring.rest_length) +
                     spring.damping * (end2.v - end1.v).dot(u);
    if (spring.only_pulls) tension = std::max(0.0, tension);
    push(spring.body1, tension * u, end1.x);
    push(spring.body2, -tension * u, end2.x);
}

// Adds the force and the torque, multiplied by factor(t) sin(2π f t + φ), where t is `now`. If the
// frequency f is 0, the sine is left out; if there is no factor, the factor is 1.
void AppliedWrenches::add_force(const AppliedForce& force, double now)
{
    const Motion& m = motions_[force.body];
    const double angle = 2 * std::numbers::pi * force.frequency * now + force.phase;
    double share = force.frequency == 0 ? 1 : std::sin(angle);
    if (force.factor) share *= force.factor(now);
    const auto in_world = [&](const Vector3d& v) -> Vector3d {
        if (force.turns_with_body) return share * (m.R * v);
        return share * v;
    };
    if (!force.force.isZero(0))
        push(force.body, in_world(force.force), world_point(m.R, m.X, force.point));
    torques_[force.body] += in_world(force.torque);
}

const std::vector<Wrench>& AppliedWrenches::at(std::span<const RigidState> states, double middle,
                                               double now)
{
    for (int i : bodies_) {
        motions_[i] = motion_of(world_.settings.integrator, world_.bodies[i], states[i],
                                depends_on_velocities_);
        forces_[i].clear();
        torques_[i].setZero();
    }
    for (int i : driven_) {
        const Drive& drive = *world_.bodies[i].drive;
        const RigidState state = driven_state(drive, now);
        motions_[i] = {body_rotation(world_.settings.integrator, state), state.position,
                       state.velocity, drive_velocity(drive, now).angular};
    }
    for (const Spring& spring : world_.springs)
        add_spring(spring);
    for (const AppliedForce& force : world_.forces)
        if (acts(force, middle)) add_force(force, now);
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        const int i = bodies_[k];
        const Vector3d& X = motions_[i].X;
        net_[k] = gravity_on(world_.settings, world_.bodies[i], X);
        net_[k].torque += torques_[i];
        if (!supports_.empty()) {
            net_[k].force += supports_[i].force;
            net_[k].torque += supports_[i].torque;
        }
        if (const Drag& drag = world_.bodies[i].drag; drag.acts()) {
            // F = -(c + k |V|) V,  τ = -d ω
            const Vector3d& V = motions_[i].V;
            net_[k].force -= (drag.linear + drag.quadratic * V.norm()) * V;
            net_[k].torque -= drag.turning * motions_[i].omega;
        }
        if (forces_[i].empty()) continue;
        const Wrench pull = net_wrench(forces_[i], X);
        net_[k].force += pull.force;
        net_[k].torque += pull.torque;
    }
    return net_;
}

} // namespace rigor
