// SPDX-License-Identifier: MIT
// The rigid bodies whose velocities an implicit step solves for together with those of the nodes.
#pragma once

#include "deformable/contact/node_contacts.hpp"
#include "deformable/solvers/ties.hpp"

namespace rigor {

class JoinedBodies {
public:
    /// Finds the bodies that join the system: the movers of the bodies that touch the solid or may
    /// touch it in this step. Each starts with the velocity that it would have at the end of the
    /// step without the solid. A static mover does not join: its velocity is given.
    void join(const RigidColliders& rigid, const std::vector<NodeContact>& contacts,
              double time_step);

    bool is_empty() const { return before_.empty(); }
    /// The index of a rigid body among the joined bodies, or -1 if the body has not joined.
    int number(int body) const { return numbers_[body]; }

    /// Resets the bodies to their velocities without contacts. @return the bodies to pass to
    /// `ImplicitSystem::solve`
    std::vector<SystemBody>& restart();

    /// Velocity of the point at r from the center of a body's mover [m/s], before contacts act.
    Vector3d velocity_before(const RigidColliders& rigid, int body, const Vector3d& r) const;
    /// Velocity of the point at r from the center of a body's mover [m/s], after the latest solve
    /// that contained the joined bodies.
    Vector3d velocity_after(const RigidColliders& rigid, int body, const Vector3d& r) const;

private:
    Vector3d velocity(const RigidColliders& rigid, int body, const Vector3d& r,
                      const std::vector<SystemBody>& bodies) const;

    std::vector<int> numbers_; // for each rigid body, what `number` returns
    std::vector<SystemBody> before_,
        after_; // the bodies before contacts act, and after the latest solve
};

} // namespace rigor
