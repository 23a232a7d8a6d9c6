// SPDX-License-Identifier: MIT
// Keeps copies of the rigid bodies during a step of the deformable solids. Impulses act on the
// copies, substeps move their surfaces, and at the end the new velocities go to the world.
#include "deformable/contact/rigid_colliders.hpp"

#include "formulas/collision.hpp"
#include "rigid/bodies/orientation.hpp"
#include "rigid/motion/free_flight.hpp"
#include "rigid/step/sleep.hpp"

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
    : world(of), is_pushed(of.bodies.size(), 0), is_supported(of.bodies.size(), 0)
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

void RigidColliders::push(int body, const Vector3d& point, const Vector3d& impulse)
{
    if (bodies[body].is_static()) return;
    bodies[body] = apply_impulse(bodies[body], point, impulse);
    is_pushed[body] = 1;
}

void RigidColliders::apply_to(World& to, double time_step) const
{
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!is_pushed[i]) continue;
        if (to.bodies[i].rest.is_asleep()) wake(to, {static_cast<int>(i)});
        // The nodes move with their velocities at the end of the step. A body that only nodes carry
        // has to move in the same way, so that it stays on them: by h V + h² g, with the velocity V
        // after the impulses. The step of the rigid bodies will move it by h V + ½ h² g if the
        // integrator follows a parabola, and by h V + h² g if it is symplectic Euler. The
        // difference is added here.
        const double lacks = 1 - fall_in_step(to.settings.integrator);
        if (!is_supported[i])
            to.bodies[i].state.position += lacks * time_step * time_step * to.settings.gravity;
        to.bodies[i].state.velocity = bodies[i].velocity;
        to.bodies[i].state.angular_momentum = bodies[i].angular_momentum;
    }
}

} // namespace rigor
