// SPDX-License-Identifier: MIT
// The active set of the contacts in an implicit step: which contacts hold their nodes, and whether
// these nodes stick or slide.
#pragma once

#include "deformable/contact/held_axes.hpp"
#include "deformable/motion/joined_bodies.hpp"

#include <optional>

namespace rigor {

/// What the contacts of a step depend on. The references stay valid during the whole step.
struct ContactStep {
    const Deformable& solid;
    const RigidColliders& rigid;
    const JoinedBodies& bodies;
    const std::vector<NodeContact>& contacts;
    const std::vector<HeldAxes>& held; // for each node
    Vector3d gravity;                  // [m/s²]
    double time_step = 0;              // h [s]
    double radius = 0;                 // half the diagonal of the bounding box of the solid [m]
};

/// A contact is open (it does not act on its node), or it holds its node, which sticks or slides.
enum class ContactMode : char { open, sticking, sliding };

class ContactSet {
public:
    /// Makes a first guess for each contact: it holds its node if the node would otherwise be
    /// inside the body after the step. With friction the node sticks, without friction it slides.
    /// The contacts of a node that handles keep from moving along the normal are open.
    void guess(const ContactStep& step);

    /// Chooses for each node, among the contacts that hold it, the one with the smallest gap. Only
    /// this contact ties the node, which means that it prescribes the node's velocity in the linear
    /// system (ties.hpp).
    void choose_ties();
    /// Whether contact k ties its node, as `choose_ties` has chosen.
    bool is_tied(int k) const { return tied_by_[step_->contacts[k].node] == k; }
    /// For each node, the index of the contact that ties it, or -1 for none.
    const std::vector<int>& tied_by() const { return tied_by_; }
    /// The constraint by which contact k ties its node in the linear system.
    TiedNode tie(int k) const;

    /// Notes the impulse of contact k after a solve in which it tied its node.
    /// @param residual  the impulse of all ties of the node (contact and handles) [N s]
    void set_impulse(int k, const Vector3d& residual);
    /// The impulse that contact k gave its node in the latest solve in which it tied the node
    /// [N s]; zero if there was no such solve in this step.
    const Vector3d& impulse(int k) const { return impulses_[k]; }

    /// Corrects the mode and the damping of a contact after a solve.
    ///
    /// @param velocity  velocity of the contact's node after the solve [m/s]
    /// @param diagonal  diagonal block of the node in the matrix of the system [kg]
    /// @return whether the contact changed, so that the part of the solid that contains its node
    ///         has to be solved for again
    bool revise(int k, const Vector3d& velocity, const Matrix3d& diagonal);

private:
    Vector3d arm(const NodeContact& contact) const;
    bool revise_free(int k, const Vector3d& velocity);
    bool revise_tied(int k, const Vector3d& velocity, const Matrix3d& diagonal);
    void revise_damping(int k, double speed, double most, double largest);
    double slip_speed(const NodeContact& contact, const Vector3d& velocity) const;

    // A damping, and the slip speed that a solve has found with it.
    struct Sliding {
        double damping = 0, speed = 0; // [kg], [m/s]
    };

    std::optional<ContactStep> step_;
    std::vector<ContactMode> modes_; // for each contact
    // For each contact that slides, its friction impulse divided by its slip speed [kg].
    std::vector<double> dampings_;
    std::vector<Sliding> last_slidings_; // for each contact; zero before its first solve
    std::vector<char> has_stopped_;      // for each contact, whether it slid and then stuck
    std::vector<Vector3d> impulses_;     // for each contact, its impulse on the node [N s]
    std::vector<int> tied_by_;           // for each node, the contact that ties it, or -1
};

} // namespace rigor
