// SPDX-License-Identifier: MIT
// The bodies and contacts of one time step, and the two stages that change their momentum.
#pragma once

#include "formulas/collision.hpp"
#include "rigid/joined.hpp"
#include "rigid/neighbourhood.hpp"
#include "rigid/optimised_forms.hpp"
#include "rigid/team.hpp"
#include "rigid/world.hpp"

#include <span>

namespace rigor {

/// A contact while a step is being solved. All of it belongs to the poses at the step's start: lever
/// arms and positions then agree, and momentum and angular momentum are kept to rounding.
struct SolvedContact : Contact {
    double restitution = 0, friction = 0;
    double radius = 0;                   // of the smaller body that can move [m]
    double force_speed = 0;              // what forces add to v·n in this step [m/s]
    double free_speed = 0;               // v·n after them, without any impulse [m/s]
    Matrix3d K = Matrix3d::Zero();       // K₁ + K₂ [1/kg]
    double normal_K = 0;                 // nᵀKn [1/kg]
    double tangential_K = 0;             // λ, the larger eigenvalue of K across n [1/kg]
    Vector3d bounce = Vector3d::Zero();  // impulse on body 1 by collisions [N s]
    Vector3d guess = Vector3d::Zero();   // where the sweeps for `holding` start from [N s]
    Vector3d holding = Vector3d::Zero(); // impulse on body 1 by contact [N s]
};

/// Contacts of one pair of bodies, contiguous, from the lowest up: [first, last).
struct ContactPair {
    int first = 0, last = 0;

    std::size_t count() const { return static_cast<std::size_t>(last - first); }
};

/// Pairs of an island, or blocks of them: [first, last).
struct IslandStretch {
    int first = 0, last = 0;
};

/// Bodies that contacts tie together, with nothing static between them.
struct Island {
    std::vector<int> bodies;
    std::vector<ContactPair> pairs; // block after block; in each from the lowest up
    // Of a large island, see `split_into_blocks`; of others there are none, or one.
    std::vector<IslandStretch> blocks; // of pairs
    std::vector<IslandStretch> stages; // of blocks that share no body that moves
};

std::size_t contacts_of(std::span<const ContactPair> pairs);

/// Whether it is more than a few bodies, and more tangled than a stack: everything touches everything.
bool is_heap(const Island& island);

/// Everything the stages work on.
struct ContactProblem {
    std::vector<Body> bodies; // of the world, in order; those without a contact stay empty
    Joined<SolvedContact> contacts;
    std::vector<Island> islands;         // those in which two bodies would penetrate
    double time_step = 0;                // [s]
    Vector3d gravity = Vector3d::Zero(); // [m/s²]
    ContactMethod method = ContactMethod::built_in;
    Skips skips;
    bool optimised = false; // the reference's formulas in a faster form
    Counters* counters = nullptr;
    Team* team = nullptr;

    /// Against gravity, unit; along y without gravity.
    Vector3d up() const;

    /// Gap at the end of the step if v·n stays [m].
    double predicted_gap(const SolvedContact& contact, double v_n) const
    {
        return contact.gap + time_step * v_n;
    }
    /// v₁ - v₂ at a point [m/s].
    Vector3d velocity_at(const SolvedContact& contact, const Vector3d& x) const
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
    Matrix3d impulse_matrix_at(const SolvedContact& contact, const Vector3d& x) const;
    /// K of a contact and what follows from it.
    void set_impulse_matrix(SolvedContact& contact) const;
    /// +j on body 1, -j on body 2.
    void apply(const SolvedContact& contact, const Vector3d& x, const Vector3d& j);
};

/// The problem of a step: contacts that are near enough to matter, in islands.
///
/// @param flown  the states after free flight: what the bodies would do without contacts
/// @param near   contacts that stay farther apart than both bodies' margins together in free flight are
///               dropped
ContactProblem contact_problem(const World& world, std::span<const RigidState> flown,
                               const Neighbourhood& near, double time_step, Counters& counters,
                               Team& team);

} // namespace rigor
