// SPDX-License-Identifier: MIT
// The bodies and contacts of one time step: the data of the collision stage, the contact stage and
// the position correction.
#pragma once

#include "formulas/collision.hpp"
#include "rigid/bodies/counters.hpp"
#include "rigid/bodies/drive.hpp"
#include "rigid/bodies/settings.hpp"
#include "rigid/bodies/step_memory.hpp"
#include "rigid/detection/contact.hpp"
#include "rigid/parallel/uninitialized_vector.hpp"

#include <limits>
#include <span>

namespace rigor {

/// A contact while a step is being solved. Its point, normal and gap belong to the poses of the
/// bodies at the start of the step, except in cases 3 and 4 below. Its two impulses, j on body 1
/// and -j on body 2, act at the same point, so momentum and angular momentum are conserved up to
/// rounding.
struct ContactConstraint : Contact {
    double restitution = 0, friction = 0;
    double radius = 0; // radius of the body that can move; if both can, the smaller radius [m]
    // `turning_speed` is the part of v·n by which rotation moves the point towards the other body,
    // ≤ 0 [m/s]. It is set only if this rotation does not close the gap (the front of a rolling
    // wheel) or if the gap already includes the rotation (case 3); otherwise it is 0.
    // `predicted_gap` adds `gap_correction` [m] to gap + h v·n, the gap that v·n predicts for the
    // end of the step (h: time step). The correction is 0 except in these cases:
    // 1. The front of a rolling wheel moves down, but also forward, so that it misses the ground.
    //    The correction adds the bend of the arc or, if the point reaches its lowest place in the
    //    step, cancels the rotation, because other points follow it.
    // 2. Two balls fly past each other. The correction is their gap at the end of the step minus
    //    the prediction gap + h v·n.
    // 3. `gap` belongs to the orientation at the end of free flight
    //    (`ContactCandidates::turned_ahead`), so it already includes the rotation. The correction
    //    is -h times the part of v·n by rotation, so that the rotation does not count twice.
    // 4. The contact was solved in the middle of the step (midpoint_contact.hpp). The correction is
    //    h times the mean of v·n over the step, minus h v·n with the v at the end of the step.
    // 5. The bodies have bounced and flown again (bounced_flight.hpp), and the contact is open
    //    after this flight. The correction raises the prediction to that gap.
    double turning_speed = 0, gap_correction = 0;
    double force_speed = 0;        // change of v·n by the forces in this step [m/s]
    double free_speed = 0;         // v·n after the forces, if there were no impulses [m/s]
    double target_speed = 0;       // least v·n allowed after the contact stage [m/s]
    Matrix3d K = Matrix3d::Zero(); // K₁ + K₂, impulse matrix of both bodies [1/kg]
    double normal_K = 0;           // nᵀKn [1/kg]
    double tangential_K = 0;       // λ, the larger eigenvalue of K in the tangent plane [1/kg]
    // Impulses on body 1 [N s]: from the collision stage, from the contact stage, and the initial
    // guess for the sweeps of the contact stage.
    Vector3d collision_impulse = Vector3d::Zero();
    Vector3d contact_impulse = Vector3d::Zero();
    Vector3d initial_impulse = Vector3d::Zero();
};

/// Whether the friction part of an impulse j on body 1 is at its limit μ j·n, up to rounding.
bool is_at_friction_limit(const ContactConstraint& contact, const Vector3d& j);

/// A gap of at most this fraction of a contact's radius counts as closed, if the poses are exact up
/// to rounding. The value is far above the rounding error of a position near the origin.
inline constexpr double touching_gap = 1e-10;
/// The limit that replaces `touching_gap` for bodies whose poses come from an iteration that may
/// have ended before it converged: the solver of the last step, or the search for a time of impact.
inline constexpr double nearly_touching_gap = 1e-6;

/// The contacts of one pair of bodies: those with the indices [first, last) in
/// `ContactProblem::contacts`, sorted by height, lowest first.
struct ContactPair {
    int first = 0, last = 0;

    std::size_t count() const { return static_cast<std::size_t>(last - first); }
};

/// The elements [first, last) of a list.
struct IndexRange {
    int first = 0, last = 0;
};

/// The frame in which an island is solved if a driven body that it touches changes its velocity
/// within the step (driven_bodies.hpp): the frame moves with the driven body. Both vectors are zero
/// if the island is solved in the world.
struct MovingFrame {
    // The mean velocity of the driven body minus its velocity at the start of the step, and its
    // velocity at the end minus its mean velocity [m/s].
    Vector3d mean_minus_first = Vector3d::Zero(), last_minus_mean = Vector3d::Zero();

    /// The change of the velocity of the driven body in this step [m/s].
    Vector3d change() const { return mean_minus_first + last_minus_mean; }
    bool is_world() const { return mean_minus_first.isZero(0) && last_minus_mean.isZero(0); }
};

/// Bodies that are not static and that are connected by contacts, directly or through other such
/// bodies. If the optimization `islands` is off, all bodies that have contacts and are not static
/// form one island.
struct Island {
    std::vector<int> bodies;
    // The pairs are sorted by block, and within a block by the height of their lowest contact.
    std::vector<ContactPair> pairs;
    // A large island is split into blocks for several threads (`split_into_blocks` in blocks.hpp).
    // A smaller island has a single block. Before `split_into_blocks` there are no blocks.
    std::vector<IndexRange> blocks; // ranges of `pairs`
    std::vector<IndexRange> colors; // ranges of `blocks`; blocks of a color share no moving body
    MovingFrame frame;              // set by `enter_moving_frames` (driven_bodies.hpp)
    // The time of impact since the start of the step [s], if the only impulse in the island is that
    // by which two bodies hit and stay together; otherwise 0. Set by `bounce_at_impacts`
    // (step/impact.hpp).
    double lands_at = 0;
    // The bounces that `bounce_at_impacts` moved to their times of impact, and the first of these
    // times since the start of the step [s].
    std::vector<ContactRecord> moved_bounces;
    double first_moved = std::numeric_limits<double>::infinity();
};

std::size_t contact_count(std::span<const ContactPair> pairs);

/// An island of at most this many bodies is never a pile (`is_pile`), because Newton's method,
/// which is not used for piles, is cheap for such an island. The method has 6 unknowns for each
/// body, so at most 48 here.
inline constexpr std::size_t few_bodies = 8;

/// Whether the island is a pile rather than a stack: it has more than `few_bodies` bodies, and
/// either more than 256 bodies or many pairs of touching bodies for their number.
bool is_pile(const Island& island);

/// A driven body that has contacts: its velocity at the start of the step, its mean velocity over
/// the step, and its velocity at the end.
struct DrivenBody {
    int body = 0;
    DriveVelocity first, mean, last;
};

/// Kinetic energy of a body or of several bodies, as seen from a frame with the velocity V [J].
double kinetic_energy_of(const Body& body, const Vector3d& V);
double kinetic_energy_of(std::span<const Body> bodies, const Vector3d& V);

/// The data on which the collision stage, the contact stage and the position correction work.
struct ContactProblem {
    std::vector<Body> bodies; // one for each body of the world; set only for those with contacts
    UninitializedVector<ContactConstraint> contacts; // sorted by `body1`, then `body2`
    std::vector<DrivenBody> driven;
    std::vector<Island> islands; // only those where two bodies would penetrate in this step
    double time_step = 0;        // [s]
    Settings settings;
    bool optimised = false; // whether optimised_forms.hpp and optimised_sweeps.hpp are used
    Counters* counters = nullptr;
    ThreadPool* pool = nullptr;

    /// The unit vector opposite to gravity, or y without gravity.
    Vector3d up() const;

    /// The motion of a driven body, or null if the body is not driven.
    const DrivenBody* drive_of(int body) const;

    /// The motions relative to which the speeds of an island are measured: those of the static and
    /// driven bodies that the island touches, in the order of their indices. All static bodies
    /// without a drive count as one. If the island touches no static or driven body, the only
    /// motion in the list is that of the island's center of mass. Speeds in the world are not used,
    /// because a scene that moves as a whole at a constant velocity has to give the same result as
    /// at rest (Galilei 1632).
    std::vector<Body> grounds_of(const Island& island) const;
    /// Copies of the bodies of an island, in the order of `island.bodies`.
    std::vector<Body> bodies_of(const Island& island) const;

    /// The gap at the end of the step if the contact keeps the normal velocity v_n [m].
    double predicted_gap(const ContactConstraint& contact, double v_n) const
    {
        return contact.gap + contact.gap_correction + time_step * v_n;
    }
    /// v₁ - v₂ at a point [m/s].
    Vector3d velocity_at(const ContactConstraint& contact, const Vector3d& x) const
    {
        return velocity_between(bodies, contact, x);
    }
    /// v₁ - v₂ at a point [m/s], with the bodies of the list `states` instead of those of the list
    /// `bodies`.
    Vector3d velocity_between(std::span<const Body> states, const Contact& contact,
                              const Vector3d& x) const;
    /// A bound of the rounding error of v₁ - v₂ [m/s]. A smaller speed counts as zero.
    double rounding_speed(const ContactConstraint& contact) const;
    /// Whether the contact stage gave a contact an impulse. An impulse that changes velocities only
    /// by a rounding error does not count. Such impulses arise for example between bodies that fly
    /// side by side after a collision.
    bool holds(const ContactConstraint& contact) const;
    /// A bound of the distance by which the point of a driven body that turns leaves its tangent in
    /// this step. At the angular velocity ω, a point at the distance r from the axis leaves it by
    /// (1 - cos h ω) r ≤ (h ω)² r/2 [m].
    double bend_of_drives(const ContactConstraint& contact) const;
    /// K₁ + K₂ at a point [1/kg].
    Matrix3d impulse_matrix_at(const ContactConstraint& contact, const Vector3d& x) const;
    /// Computes K, `normal_K` and `tangential_K` of a contact.
    void set_impulse_matrix(ContactConstraint& contact) const;
    /// Applies the impulse j at x to body 1 and -j at x to body 2 [N s].
    void apply(const ContactConstraint& contact, const Vector3d& x, const Vector3d& j);
    /// Applies the impulse j at the point x to one body, which is a body of this problem or a
    /// copy of such a body. A static body stays as it is.
    void push(Body& body, const Vector3d& x, const Vector3d& j) const;
};

} // namespace rigor
