// SPDX-License-Identifier: MIT
// The bodies and contacts of one time step, on which the stages of contact work.
#pragma once

#include "formulas/collision.hpp"
#include "rigid/bodies/counters.hpp"
#include "rigid/bodies/optimised_forms.hpp"
#include "rigid/bodies/settings.hpp"
#include "rigid/detection/contact.hpp"
#include "rigid/parallel/uninitialized_vector.hpp"

#include <span>

namespace rigor {

/// A contact while a step is being solved. All of it belongs to the poses at the step's start. Lever
/// arms and positions then agree, and momentum and angular momentum are kept to rounding.
struct ContactConstraint : Contact {
    double restitution = 0, friction = 0;
    double radius = 0;             // of the smaller body that can move [m]
    double force_speed = 0;        // what forces add to v·n in this step [m/s]
    double free_speed = 0;         // v·n after the forces, without any impulse [m/s]
    double target_speed = 0;       // v·n that the contact stage asks for [m/s]
    Matrix3d K = Matrix3d::Zero(); // K₁ + K₂ [1/kg]
    double normal_K = 0;           // nᵀKn [1/kg]
    double tangential_K = 0;       // λ, the larger eigenvalue of K across n [1/kg]
    // Impulses on body 1 [N s]: of the collision stage, of the contact stage, and where the sweeps of
    // the contact stage start from.
    Vector3d collision_impulse = Vector3d::Zero();
    Vector3d contact_impulse = Vector3d::Zero();
    Vector3d initial_impulse = Vector3d::Zero();
};

/// The contacts [first, last) of one pair of bodies, from the lowest up.
struct ContactPair {
    int first = 0, last = 0;

    std::size_t count() const { return static_cast<std::size_t>(last - first); }
};

/// Elements [first, last) of a list.
struct IndexRange {
    int first = 0, last = 0;
};

/// Bodies that contacts connect, directly or through other bodies that can move.
struct Island {
    std::vector<int> bodies;
    std::vector<ContactPair> pairs; // block after block; in each block from the lowest up
    // A large island is split for several threads, see `split_into_blocks`. Others have one block, or
    // none as long as they have not been prepared.
    std::vector<IndexRange> blocks; // ranges of `pairs`
    std::vector<IndexRange> colors; // ranges of `blocks`; those of one color share no moving body
};

std::size_t contact_count(std::span<const ContactPair> pairs);

/// Whether the island is a heap rather than a stack: many bodies with many contacts between them.
bool is_heap(const Island& island);

/// Everything the stages of contact work on.
struct ContactProblem {
    std::vector<Body> bodies; // one for each body of the world; those without contacts stay empty
    UninitializedVector<ContactConstraint> contacts;
    std::vector<Island> islands; // those in which two bodies would penetrate
    double time_step = 0;        // [s]
    Settings settings;
    bool optimised = false; // whether the faster forms of the formulas run
    Counters* counters = nullptr;
    ThreadPool* pool = nullptr;

    /// The unit vector against gravity; y without gravity.
    Vector3d up() const;

    /// Copies of the bodies of an island, in its order.
    std::vector<Body> bodies_of(const Island& island) const;

    /// Gap at the end of the step if v·n stays [m].
    double predicted_gap(const ContactConstraint& contact, double v_n) const
    {
        return contact.gap + time_step * v_n;
    }
    /// v₁ - v₂ at a point [m/s].
    Vector3d velocity_at(const ContactConstraint& contact, const Vector3d& x) const
    {
        return velocity_between(bodies, contact, x);
    }
    /// The same for bodies in another state.
    Vector3d velocity_between(std::span<const Body> states, const Contact& contact,
                              const Vector3d& x) const
    {
        const Body &body1 = states[contact.body1], &body2 = states[contact.body2];
        if (optimised) return optimised::relative_velocity(body1, body2, x);
        return relative_velocity(body1, body2, x);
    }
    /// K₁ + K₂ at a point [1/kg].
    Matrix3d impulse_matrix_at(const ContactConstraint& contact, const Vector3d& x) const;
    /// Sets K of a contact and what follows from it.
    void set_impulse_matrix(ContactConstraint& contact) const;
    /// Applies j to body 1 and -j to body 2.
    void apply(const ContactConstraint& contact, const Vector3d& x, const Vector3d& j);
};

} // namespace rigor
