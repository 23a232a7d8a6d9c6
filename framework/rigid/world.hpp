// SPDX-License-Identifier: MIT
// Bodies, forces and settings: all that a time step reads, and of what it could derive only the near pairs.
#pragma once

#include "formulas/types.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/pair_memory.hpp"
#include "rigid/team.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace rigor {

struct Material {
    double restitution = 0.5; // ε, 0 … 1; of a pair: the smaller
    double friction = 0.5;    // μ ≥ 0; of a pair: the geometric mean
};

/// How long a body has been at rest, and whether it sleeps.
struct Rest {
    double duration = 0; // since it came to this place [s]
    RigidState place;
    int group = -1; // of those that fell asleep together; -1: awake

    bool is_asleep() const { return group >= 0; }
};

/// A rigid body. Object space has its origin at the center of mass and the axes of the scene file.
struct RigidBody {
    std::string name;
    std::vector<Part> parts; // in object space
    Material material;
    bool is_static = false;
    double mass = 0;                     // [kg]; 0 if static
    Matrix3d inertia = Matrix3d::Zero(); // I_body, about the center of mass [kg m²]
    BodyInertia inverse;       // computed once, through the principal axes; zero if static
    bool is_isotropic = false; // I_body = i δ: then I(t)⁻¹ = I_body⁻¹
    // a, unit, in object space, where I_body⁻¹ = i δ + k a aᵀ, as of what is turned about a; else zero
    Vector3d symmetry_axis = Vector3d::Zero();
    RigidState state;
    Rest rest;

    bool is_symmetric() const { return !symmetry_axis.isZero(0); }

    /// Static or asleep: nothing moves it in this step.
    bool is_still() const { return is_static || rest.is_asleep(); }
};

/// A spring between two points, fixed in bodies or (body = -1) in the world.
struct Spring {
    int body1 = -1, body2 = -1;
    Vector3d point1 = Vector3d::Zero(),
             point2 = Vector3d::Zero(); // object space, or world space [m]
    double stiffness = 0;               // [N/m]
    double damping = 0;                 // along the spring [N s/m]
    double rest_length = 0;             // [m]
};

/// A constant world-space force on a point of a body, for a while.
struct AppliedForce {
    int body = 0;
    Vector3d force = Vector3d::Zero(); // [N]
    Vector3d point = Vector3d::Zero(); // object space [m]
    double start = 0, end = 1e300;     // [s]
};

/// How free flight is integrated.
enum class Integrator {
    matrix, ///< Runge–Kutta 4 on (X, R, V, L) through `equations_of_motion`, R made a rotation
            ///< again after the step
    linear, ///< `step_symplectic_euler`
    exponential, ///< symplectic Euler with `advance_exact`
    buss,        ///< `step_buss`
    runge_kutta, ///< fourth order on (X, q, V, L), the default
};

/// How the third stage of a step resolves contacts.
enum class ContactMethod {
    built_in,          ///< all at once, by the formulas of topic `collision` alone, the default
    one_at_a_time,     ///< `resolve_contacts`
    shock_propagation, ///< `resolve_contacts`, then `shock_propagation`
    simultaneous,      ///< `resolve_simultaneously`
};

/// Work that a step leaves out where the scene does not need it. Each can be turned off, to see that
/// nothing else changes and what it saves.
struct Skips {
    bool islands = true;      ///< bodies that touch are solved apart from those that they don't
    bool sleep = true;        ///< bodies that have come to rest are left alone
    bool warm_start = true;   ///< impulses start from those of the step before
    bool early_exit = true;   ///< sweeps end once nothing changes any more
    bool stress_bound = true; ///< eigenvalues of a stress only where a bound on them is too high
    /// The reference's formulas in a faster form, proved equal; never for another implementation.
    bool readable_formulas = true;
};

/// What was done, and what was skipped because the scene did not need it.
struct Counters {
    std::uint64_t steps = 0, substeps = 0;
    std::uint64_t pairs_possible = 0, pairs_tested = 0, pair_searches_saved = 0, contacts = 0;
    std::uint64_t collision_impulses = 0, contact_impulses = 0;
    std::uint64_t isotropic_shortcuts = 0, free_flights = 0, static_skipped = 0;
    std::uint64_t islands = 0, bodies_asleep = 0, warm_starts = 0; // summed over the steps
    std::uint64_t contact_sweeps = 0, early_exits = 0, newton_solves = 0;
    std::uint64_t healed_contacts = 0;
    std::uint64_t level_sets_built = 0, level_set_samples = 0;
    // of deformable solids
    std::uint64_t deformable_substeps = 0, system_solves = 0, solver_iterations = 0;
    std::uint64_t node_impulses = 0, elements_flowed = 0, flow_skipped = 0;
    std::uint64_t eigenvalues = 0, eigenvalues_skipped = 0, cracks = 0, mesh_changes = 0;
};

/// What held a contact in the step before: where the next step's sweeps start from.
struct WarmContact {
    int body1 = 0, body2 = 0;
    Vector3d point = Vector3d::Zero();   // in the object space of body 1 [m]
    Vector3d impulse = Vector3d::Zero(); // on body 1, for each second of the step [N]
};

/// A contact as it was resolved in a step.
struct ContactRecord {
    int body1 = 0, body2 = 0;
    Vector3d point = Vector3d::Zero();   // [m]
    Vector3d normal = Vector3d::UnitY(); // from body 2 to body 1
    double depth = 0;                    // as the step began; negative: the gap that it closed [m]
    Vector3d impulse = Vector3d::Zero(); // on body 1, the sum over the step [N s]
};

struct World {
    std::vector<RigidBody> bodies;
    std::vector<Spring> springs;
    std::vector<AppliedForce> forces;
    Vector3d gravity = Vector3d::Zero(); // g [m/s²]
    Integrator integrator = Integrator::runge_kutta;
    ContactMethod contact_method = ContactMethod::built_in;
    Skips skips;
    bool formulas_are_reference = false; // only then they may be skipped for a faster form
    Team team;       // of the parts that are parallel; the result is the same bits for any number
    double time = 0; // [s]
    std::vector<WarmContact> warm_contacts; // of the step before, in the order of their bodies
    std::vector<ContactRecord> sleeping_contacts; // what holds the bodies that sleep
    PairMemory near; // saves work alone: the result is the same bits without it
    Counters counters;
};

/// One time step in the order of Guendelman, Bridson and Fedkiw (2003): collisions, velocities,
/// contact, positions. A pure function of (world, time_step): no state is hidden elsewhere. Without
/// warm start and sleep it depends on the bodies' states alone.
/// @return the contacts that got an impulse
std::vector<ContactRecord> step(World& world, double time_step);

} // namespace rigor
