// SPDX-License-Identifier: MIT
// Settings of a simulation, which stay the same from step to step.
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// How free flight is integrated. The recipe "An integrator of free flight" in CONTRIBUTING.md says
/// how to add another integrator.
enum class Integrator {
    matrix, ///< Runge–Kutta 4 on (X, R, V, L) through `equations_of_motion`; R is made a rotation
            ///< again after each step
    linear, ///< symplectic Euler by the formula `step_symplectic_euler`
    exponential,  ///< symplectic Euler with `advance_exact`
    buss,         ///< Buss's method by the formula `step_buss`
    runge_kutta,  ///< methods of fourth order on (X, q, V, L), see free_flight.hpp
    gram_schmidt, ///< symplectic Euler with `advance_matrix` and `gram_schmidt`; shows the bias of
                  ///< Gram–Schmidt
    euler_angles, ///< symplectic Euler with `euler_rates`; shows that these fail at gimbal lock
    /// The default: a body that only gravity acts on flies exactly, by Jacobi's solution for the
    /// free rotor. A body that springs, forces, drag or contacts act on takes `runge_kutta`. The
    /// value `exact` has to stay the last, because checks take the number of integrators from it.
    exact,
};

/// How the contact stage of a step resolves contacts.
enum class ContactMethod {
    /// The default: all contacts of an island (a group of touching bodies) at once, by sweeps with
    /// the law of `collision_impulse`, and by Newton's method where the sweeps do not converge.
    built_in,
    one_at_a_time,     ///< by the formula `resolve_contacts`
    shock_propagation, ///< by the formulas `resolve_contacts` and then `shock_propagation`
    simultaneous,      ///< as `built_in`, but with sweeps by the formula `resolve_simultaneously`
};

/// Optimizations that leave out work that a scene does not need. Each of them is used if its value
/// is true. A scene can turn each of them off, to measure the time that it saves and to check that
/// the result stays the same, or the same within a bound that a test states. counters.hpp lists
/// most kinds of work that are left out, also those without a switch here.
struct Optimisations {
    bool islands = true;      ///< solves each group of touching bodies on its own
    bool sleep = true;        ///< skips bodies that have come to rest
    bool warm_start = true;   ///< starts from the impulses of the previous step
    bool early_exit = true;   ///< ends the sweeps as soon as their changes are negligible
    bool stress_bound = true; ///< skips eigenvalues of a stress that is too low for a crack
    /// Runs faster forms of the formulas of the reference implementation, which give the same
    /// results up to rounding. Formulas of other implementations are always called as they are
    /// written.
    bool optimised_formulas = true;
};

struct Settings {
    Vector3d gravity = Vector3d::Zero(); // g [m/s²]
    Integrator integrator = Integrator::exact;
    ContactMethod contact_method = ContactMethod::built_in;
    Optimisations optimisations;
    bool formulas_are_reference = false; // whether the reference implementation is linked

    /// The integrator of a body that springs, forces, drag or contacts act on.
    Integrator integrator_under_forces() const
    {
        return integrator == Integrator::exact ? Integrator::runge_kutta : integrator;
    }

    /// Whether the engine may run its faster forms of the formulas.
    bool uses_optimised_formulas() const
    {
        return formulas_are_reference && optimisations.optimised_formulas;
    }
};

} // namespace rigor
