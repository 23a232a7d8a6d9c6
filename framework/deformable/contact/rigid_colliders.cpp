// SPDX-License-Identifier: MIT
// Keeps copies of the rigid bodies during a step of the deformable solids. Impulses act on the
// copies, substeps move their surfaces, and at the end the new velocities go to the world.
#include "deformable/contact/rigid_colliders.hpp"

#include "formulas/collision.hpp"
#include "rigid/bodies/orientation.hpp"
#include "rigid/motion/free_flight.hpp"
#include "rigid/step/sleep.hpp"

#include <utility>

namespace rigor {

namespace {

Body collider_in_world(const World& world, const RigidBody& rigid)
{
    Body body = body_in_world(world.settings.integrator, rigid);
    if (rigid.is_static && rigid.drive) {
        const DriveVelocity driven = drive_velocity(*rigid.drive, world.time);
        body.velocity = driven.linear;
        body.angular_velocity = driven.angular;
    }
    return body;
}

} // namespace

RigidColliders::RigidColliders(const World& of)
    : world(of), is_pushed(of.bodies.size(), 0), is_supported(of.bodies.size(), 0),
      reached_(of.bodies.size())
{
    bodies.reserve(of.bodies.size());
    surfaces.reserve(of.bodies.size());
    for (std::size_t i = 0; i < of.bodies.size(); ++i) {
        const RigidBody& rigid = of.bodies[i];
        bodies.push_back(collider_in_world(of, rigid));
        surfaces.push_back(
            {body_rotation(of.settings.integrator, rigid.state), rigid.state.position});
        is_supported[i] = rigid.rest.is_asleep();
    }
    for (const WarmContact& c : of.memory.warm_contacts)
        is_supported[c.body1] = is_supported[c.body2] = 1;
}

void RigidColliders::advance(double time_step)
{
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].is_static() && !world.bodies[i].changes_place()) continue;
        const Vector3d turn = time_step * bodies[i].angular_velocity;
        const double angle = turn.norm();
        surfaces[i].X += time_step * bodies[i].velocity;
        if (angle > 0) surfaces[i].R = Eigen::AngleAxisd(angle, turn / angle) * surfaces[i].R;
    }
}

void RigidColliders::fall(double time)
{
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (!bodies[i].is_static() && !is_supported[i])
            bodies[i].velocity += time * world.settings.gravity;
}

void RigidColliders::begin_substeps()
{
    pushed_before_ = std::exchange(is_pushed, std::vector<char>(bodies.size(), 0));
}

void RigidColliders::end_substeps(double time_step)
{
    fall(-time_step);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (is_pushed[i]) reached_[i] = surfaces[i].X;
        is_pushed[i] |= pushed_before_[i];
    }
}

void RigidColliders::push(int body, const Vector3d& point, const Vector3d& impulse)
{
    if (bodies[body].is_static()) return;
    bodies[body] = apply_impulse(bodies[body], point, impulse);
    is_pushed[body] = 1;
    reached_[body].reset();
}

// The nodes of an implicit solid move with their velocities at the end of the step. A body that
// only nodes carry has to move in the same way, so that it stays on them: by h V + h² g, with the
// velocity V after the impulses. The nodes of an explicit solid have moved beside the body in
// substeps, so the body has to come where these have brought it. The step of the rigid bodies will
// move it by h V + ½ h² g if the integrator follows a parabola, and by h V + h² g if it is
// symplectic Euler. The result is the difference.
Vector3d RigidColliders::lack_of_motion(std::size_t body, double h) const
{
    const Vector3d& g = world.settings.gravity;
    const double part = fall_in_step(world.settings.integrator);
    if (!reached_[body]) return (1 - part) * h * h * g;
    return *reached_[body] - world.bodies[body].state.position -
           (h * bodies[body].velocity + part * h * h * g);
}

void RigidColliders::apply_to(World& to, double time_step) const
{
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!is_pushed[i]) continue;
        if (to.bodies[i].rest.is_asleep()) wake(to, {static_cast<int>(i)});
        if (!is_supported[i]) to.bodies[i].state.position += lack_of_motion(i, time_step);
        to.bodies[i].state.velocity = bodies[i].velocity;
        to.bodies[i].state.angular_momentum = bodies[i].angular_momentum;
    }
}

} // namespace rigor
