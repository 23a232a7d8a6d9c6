// SPDX-License-Identifier: MIT
#include "rigid/forces.hpp"

#include "formulas/kinematics.hpp"
#include "formulas/rotation.hpp"

namespace rigor {

namespace {

using PointForces = std::vector<std::vector<PointForce>>; // for each body

bool acts(const AppliedForce& force, double time)
{
    return force.start <= time && time < force.end;
}

// One end of a spring: where it is, and how fast that moves if the spring damps.
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

void add_spring(const Spring& spring, std::span<const Motion> motions, PointForces& forces)
{
    const bool damps = spring.damping != 0;
    const SpringEnd end1 = spring_end(spring.body1, spring.point1, damps, motions);
    const SpringEnd end2 = spring_end(spring.body2, spring.point2, damps, motions);
    const Vector3d d = end2.x - end1.x;
    const double length = d.norm();
    if (length == 0) return; // no direction to pull in

    // f₁ = (k (|d| - l₀) + c (v₂ - v₁)·u) u,  u = d/|d|,  f₂ = -f₁
    const Vector3d u = d / length;
    const double tension = spring.stiffness * (length - spring.rest_length) +
                           spring.damping * (end2.v - end1.v).dot(u);
    if (spring.body1 >= 0) forces[spring.body1].push_back({tension * u, end1.x});
    if (spring.body2 >= 0) forces[spring.body2].push_back({-tension * u, end2.x});
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

Wrench gravity_on(const World& world, const RigidBody& body, const Vector3d& X)
{
    if (world.gravity.isZero(0)) return {};
    if (world.integrator == Integrator::matrix)
        return net_wrench({{body.mass * world.gravity, X}}, X);
    return gravity_wrench(body.mass, world.gravity);
}

Vector3d up_against(const Vector3d& gravity)
{
    const double g = gravity.norm();
    return g > 0 ? Vector3d(-gravity / g) : Vector3d::UnitY();
}

std::vector<Wrench> wrenches(const World& world, std::span<const Motion> motions, double time)
{
    PointForces forces(world.bodies.size());
    for (const Spring& spring : world.springs)
        add_spring(spring, motions, forces);
    for (const AppliedForce& force : world.forces)
        if (acts(force, time)) {
            const Motion& m = motions[force.body];
            forces[force.body].push_back({force.force, world_point(m.R, m.X, force.point)});
        }

    std::vector<Wrench> net(world.bodies.size());
    for (std::size_t i = 0; i < net.size(); ++i) {
        const RigidBody& body = world.bodies[i];
        if (body.is_static) continue;
        if (!forces[i].empty()) net[i] = net_wrench(forces[i], motions[i].X);
        const Wrench gravity = gravity_on(world, body, motions[i].X);
        net[i].force += gravity.force;
        net[i].torque += gravity.torque;
    }
    return net;
}

} // namespace rigor
