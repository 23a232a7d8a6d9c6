// SPDX-License-Identifier: MIT
// Collects the rigid bodies that join the system of an implicit step, and gives the velocities of
// their points before and after a solve.
#include "deformable/motion/joined_bodies.hpp"

#include <algorithm>

namespace rigor {

namespace {

// Whether a contact of the solid pushes the mover of a body against one of its supports.
bool is_pushed_against_supports(const RigidColliders& rigid,
                                const std::vector<NodeContact>& contacts, int body)
{
    return std::any_of(contacts.begin(), contacts.end(), [&](const NodeContact& c) {
        return rigid.mover_number(c.body) == rigid.mover_number(body) &&
               !rigid.mover(body).yields(-c.normal);
    });
}

} // namespace

void JoinedBodies::join(const RigidColliders& rigid, const std::vector<NodeContact>& contacts,
                        double time_step)
{
    const int bodies = static_cast<int>(rigid.surfaces.size());
    numbers_.assign(bodies, -1);
    before_.clear();
    for (const NodeContact& c : contacts) {
        if (numbers_[c.body] >= 0 || rigid.mover(c.body).body.is_static()) continue;
        for (int i = 0; i < bodies; ++i)
            if (rigid.mover_number(i) == rigid.mover_number(c.body))
                numbers_[i] = static_cast<int>(before_.size());
        const Mover& mover = rigid.mover(c.body);
        before_.push_back(
            {is_pushed_against_supports(rigid, contacts, c.body) ? mover.mass : mover.free_mass,
             mover.body.velocity + time_step * mover.acceleration,
             mover.body.angular_velocity + time_step * mover.angular_acceleration});
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
    const Body& mover = rigid.mover(body).body;
    return number < 0 ? mover.velocity + mover.angular_velocity.cross(r)
                      : bodies[number].V + bodies[number].w.cross(r);
}

} // namespace rigor
