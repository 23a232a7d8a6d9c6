// SPDX-License-Identifier: MIT
// How a world is simulated: what stays the same from step to step.
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// How free flight is integrated.
enum class Integrator {
    matrix, ///< Runge–Kutta 4 on (X, R, V, L) through `equations_of_motion`; R becomes a rotation
            ///< again after each step
    linear, ///< `step_symplectic_euler`
    exponential, ///< symplectic Euler with `advance_exact`
    buss,        ///< `step_buss`
    runge_kutta, ///< fourth order on (X, q, V, L), the default
};

/// How the contact stage of a step resolves contacts.
enum class ContactMethod {
    built_in,          ///< all at once, by the formulas of topic `collision` alone, the default
    one_at_a_time,     ///< `resolve_contacts`
    shock_propagation, ///< `resolve_contacts`, then `shock_propagation`
    simultaneous,      ///< `resolve_simultaneously`
};

/// Ways to leave out work that a scene does not need; true: the way is taken. Each can be turned off,
/// to see that nothing else changes and what it saves.
struct Skips {
    bool islands = true;      ///< solves bodies that touch apart from those that they don't touch
    bool sleep = true;        ///< leaves bodies alone that have come to rest
    bool warm_start = true;   ///< starts from the impulses of the step before
    bool early_exit = true;   ///< ends the sweeps once nothing changes any more
    bool stress_bound = true; ///< computes eigenvalues of a stress only where a bound is too high
    /// Runs the reference's formulas in a faster form, proved equal. Other implementations of the
    /// formulas are always called as they are written.
    bool optimised_formulas = true;
};

struct Settings {
    Vector3d gravity = Vector3d::Zero(); // g [m/s²]
    Integrator integrator = Integrator::runge_kutta;
    ContactMethod contact_method = ContactMethod::built_in;
    Skips skips;
    bool formulas_are_reference = false; // whether the linked formulas are the reference's

    /// Whether the engine may run its faster forms of the formulas.
    bool uses_optimised_formulas() const
    {
        return formulas_are_reference && skips.optimised_formulas;
    }
};

} // namespace rigor
