// SPDX-License-Identifier: MIT
// Collects the rigid bodies that join the system of an implicit step, and gives the velocities of
// their points before and after a solve.
#include "deformable/motion/joined_bodies.hpp"

namespace rigor {

void JoinedBodies::join(const RigidColliders& rigid, const std::vector<NodeContact>& contacts,
                        double time_step)
{
    numbers_.assign(rigid.bodies.size(), -1);
    before_.clear();
    for (const NodeContact& c : contacts) {
        const Body& body = rigid.bodies[c.body];
        if (body.is_static() || numbers_[c.body] >= 0 || rigid.is_supported[c.body]) continue;
        numbers_[c.body] = static_cast<int>(before_.size());
        before_.push_back({1 / body.inverse_mass, body.inverse_inertia.inverse(),
                           body.velocity + time_step * rigid.world.settings.gravity,
                           body.angular_velocity});
    }
}

std::vector<SystemBody>& JoinedBodies::restart()
{
    after_ = before_;
    return after_;
}

Vector3d JoinedBodies::velocity_before(const RigidColliders& rigid, int body,
                                       const Vector3d& r) const
{
    return velocity(rigid, body, r, before_);
}

Vector3d JoinedBodies::velocity_after(const RigidColliders& rigid, int body,
                                      const Vector3d& r) const
{
    return velocity(rigid, body, r, after_);
}

Vector3d JoinedBodies::velocity(const RigidColliders& rigid, int body, const Vector3d& r,
                                const std::vector<SystemBody>& bodies) const
{
    const int number = numbers_[body];
    return number < 0 ? rigid.bodies[body].velocity + rigid.bodies[body].angular_velocity.cross(r)
                      : bodies[number].V + bodies[number].w.cross(r);
}

} // namespace rigor
