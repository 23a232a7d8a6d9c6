// SPDX-License-Identifier: MIT
// Keeps the movers and surfaces of the rigid bodies during a step of the deformable solids.
// Impulses act on the movers, substeps move the surfaces, and at the end the impulses become
// forces of the step of the rigid bodies. As forces they act together with gravity and with the
// contacts between rigid bodies, so that a body or a stack that rests on a solid does not move.
#include "deformable/contact/rigid_colliders.hpp"

#include "rigid/bodies/orientation.hpp"
#include "rigid/motion/free_flight.hpp"
#include "rigid/step/sleep.hpp"

#include <algorithm>

namespace rigor {

RigidColliders::RigidColliders(World& of, double time_step)
    : world(of), time_step_(time_step), movers_(movers_of(of, time_step)),
      pushed_(of.bodies.size()), pushed_in_substeps_(movers_.all.size(), 0),
      has_reached_(movers_.all.size(), 0), first_force_(of.forces.size())
{
    surfaces.reserve(of.bodies.size());
    for (const RigidBody& rigid : of.bodies)
        surfaces.push_back(
            {body_rotation(of.settings.integrator, rigid.state), rigid.state.position});
}

Vector3d RigidColliders::velocity_of(int body) const
{
    const Body& m = mover(body).body;
    return m.velocity + m.angular_velocity.cross(world.bodies[body].state.position - m.position);
}

void RigidColliders::advance(double time_step)
{
    for (int i = 0; i < static_cast<int>(surfaces.size()); ++i) {
        const Body& m = mover(i).body;
        if (m.is_static() && !world.bodies[i].changes_place()) continue;
        const Vector3d turn = time_step * m.angular_velocity;
        const double angle = turn.norm();
        surfaces[i].X += time_step * velocity_of(i);
        if (angle > 0) surfaces[i].R = Eigen::AngleAxisd(angle, turn / angle) * surfaces[i].R;
    }
}

void RigidColliders::fall(double time)
{
    for (Mover& mover : movers_.all) {
        mover.body.velocity += time * mover.acceleration;
        mover.body.angular_velocity += time * mover.angular_acceleration;
    }
}

void RigidColliders::begin_substeps()
{
    std::fill(pushed_in_substeps_.begin(), pushed_in_substeps_.end(), 0);
}

void RigidColliders::end_substeps()
{
    fall(-time_step_);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (!pushed_in_substeps_[movers_.of[i]]) continue;
        has_reached_[movers_.of[i]] = 1;
        pushed_[i].reached = surfaces[i].X;
    }
}

Vector3d RigidColliders::at_start(int body, const Vector3d& x) const
{
    return x - (surfaces[body].X - world.bodies[body].state.position);
}

void RigidColliders::push(int body, const Vector3d& point, const Vector3d& impulse)
{
    const RigidBody& rigid = world.bodies[body];
    if (rigid.is_static) return;
    Pushed& pushed = pushed_[body];
    pushed.impulse += impulse;
    pushed.moment += (point - rigid.state.position).cross(impulse);
    pushed.is_pushed = true;
    const int number = movers_.of[body];
    pushed_in_substeps_[number] = 1;
    has_reached_[number] = 0;
    movers_.all[number].push(point, impulse);
}

// The displacement [m] that a body lacks to stay on the nodes that support it, after the step of
// the rigid bodies. This step alone moves the body by h V + p h ΔV, where ΔV is the change of
// velocity in the step, and p is ½ if the integrator follows a parabola and 1 for symplectic Euler.
// The nodes of an implicit solid move with their velocities at the end of the step, so the body has
// to move by h (V + ΔV). The nodes of an explicit solid have moved in substeps together with the
// body's surface, so the body has to move to the place that this surface has reached.
Vector3d RigidColliders::lack_of_motion(int body) const
{
    const double p = fall_in_step(world.settings.integrator_under_forces()), h = time_step_;
    const Vector3d& X = world.bodies[body].state.position;
    const Mover& m = mover(body);
    const Vector3d r = X - m.body.position,
                   start = m.start.velocity + m.start.angular_velocity.cross(r),
                   change = velocity_of(body) - start +
                            h * (m.acceleration + m.angular_acceleration.cross(r));
    if (!has_reached_[movers_.of[body]]) return (1 - p) * h * change;
    return pushed_[body].reached - X - h * start - p * h * change;
}

void RigidColliders::apply_to(World& to) const
{
    std::vector<char> is_mover_pushed(movers_.all.size(), 0);
    for (std::size_t i = 0; i < pushed_.size(); ++i)
        if (pushed_[i].is_pushed) is_mover_pushed[movers_.of[i]] = 1;
    for (int i = 0; i < static_cast<int>(pushed_.size()); ++i) {
        if (is_mover_pushed[movers_.of[i]] && !mover(i).body.is_static() && !mover(i).is_carried())
            to.bodies[i].state.position += lack_of_motion(i);
        if (!pushed_[i].is_pushed) continue;
        if (to.bodies[i].rest.is_asleep()) wake(to, {i});
        AppliedForce nodes;
        nodes.body = i;
        nodes.start = -nodes.end; // the end is 1e300, so the force acts at all times
        nodes.is_of_solid = true;
        nodes.force = pushed_[i].impulse / time_step_;
        nodes.torque = pushed_[i].moment / time_step_;
        to.forces.push_back(nodes);
    }
}

} // namespace rigor
