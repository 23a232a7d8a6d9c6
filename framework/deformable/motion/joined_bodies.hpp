// SPDX-License-Identifier: MIT
// The rigid bodies whose velocities an implicit step solves for together with those of the nodes.
#pragma once

#include "deformable/contact/node_contacts.hpp"
#include "deformable/solvers/ties.hpp"

namespace rigor {

class JoinedBodies {
public:
    /// A dynamic body in contact joins the system, with the velocity that gravity will give it in
    /// this step. A body that rests on other bodies does not join and counts as static here,
    /// because it passes the impulses on to its supports.
    void join(const RigidColliders& rigid, const std::vector<NodeContact>& contacts,
              double time_step);

    bool is_empty() const { return before_.empty(); }
    /// The number in the system of a rigid body, or -1 if the body has not joined.
    int number(int body) const { return numbers_[body]; }

    /// Resets the bodies to their velocities without contacts. @return the bodies to pass to
    /// `ImplicitSystem::solve`
    std::vector<SystemBody>& restart();

    /// Velocity of the point at r from the center of a body [m/s], before contacts act.
    Vector3d velocity_before(const RigidColliders& rigid, int body, const Vector3d& r) const;
    /// The velocity of that point after the latest solve that contained the bodies [m/s].
    Vector3d velocity_after(const RigidColliders& rigid, int body, const Vector3d& r) const;

private:
    Vector3d velocity(const RigidColliders& rigid, int body, const Vector3d& r,
                      const std::vector<SystemBody>& bodies) const;

    std::vector<int> numbers_;               // `number` of each rigid body
    std::vector<SystemBody> before_, after_; // velocities without contacts, and after a solve
};

} // namespace rigor
