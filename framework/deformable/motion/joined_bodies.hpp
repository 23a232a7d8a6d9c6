// SPDX-License-Identifier: MIT
// The rigid bodies whose velocities an implicit step solves for together with those of the nodes.
#pragma once

#include "deformable/contact/node_contacts.hpp"
#include "deformable/solvers/ties.hpp"

namespace rigor {

class JoinedBodies {
public:
    /// A dynamic body in contact joins the system, with the velocity that gravity will give it in
    /// this step, unless it rests on other bodies. Such a body counts as static here, because it
    /// hands the impulses on to its supports.
    void join(const RigidColliders& rigid, const std::vector<NodeContact>& contacts,
              double time_step);

    bool is_empty() const { return before_.empty(); }
    /// The number of a rigid body in the system; -1: it has not joined.
    int number(int body) const { return numbers_[body]; }

    /// Starts a solve from the velocities without contacts. Its argument to
    /// `ImplicitSystem::solve`.
    std::vector<SystemBody>& restart();

    /// Velocity of the point r away from the center of a body [m/s], before contacts act.
    Vector3d velocity_before(const RigidColliders& rigid, int body, const Vector3d& r) const;
    /// The same after the latest solve that had the bodies in it.
    Vector3d velocity_after(const RigidColliders& rigid, int body, const Vector3d& r) const;

private:
    Vector3d velocity(const RigidColliders& rigid, int body, const Vector3d& r,
                      const std::vector<SystemBody>& bodies) const;

    std::vector<int> numbers_;               // for each rigid body
    std::vector<SystemBody> before_, after_; // velocities without contacts, and as solved for
};

} // namespace rigor
