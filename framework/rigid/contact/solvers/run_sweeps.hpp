// SPDX-License-Identifier: MIT
// Repeats sweeps over an island's contacts, up to a limit or until their changes are negligible.
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// A run of sweeps ends after `most_sweeps` sweeps. With the optimization `early_exit`, it also
/// ends when a sweep changes no velocity by more than `negligible_change` plus a rounding error.
struct SweepLimits {
    int most_sweeps = 0;
    double negligible_change = 0; // [m/s]
};

/// Convergence of a run of sweeps: `SweepProgress::change` of the first and of the last sweep
/// [m/s], and the number of sweeps.
struct Residuals {
    double first = 0, last = 0;
    int sweeps = 0;
    bool has_converged = false; // whether the change of the last sweep is negligible

    /// An estimate of the sum of all changes that further sweeps would make [m/s]. It assumes that
    /// each further sweep reduces the change by the mean factor of the sweeps so far. Under a heavy
    /// body the change of one sweep is a small part of this sum: a ten millionth of it at a mass
    /// ratio of 1e7. The estimate always assumes some decay, so that a rounding error, which does
    /// not decay, adds up to a small sum instead of an infinite one.
    double missing() const;
};

/// Sweeps until the changes are negligible or the number of sweeps reaches its limit. After each
/// sweep, the impulses also move along a search direction that combines the changes of the sweeps
/// so far (nonlinear conjugate gradients). If `steps` are the changes of the impulses by the sweep:
///
///     impulses += β directions   and then   directions = steps + β directions
///
/// Here β is `SweepProgress::squared` of this sweep, divided by that of the previous sweep. β is 0
/// after the first sweep, after a sweep in which `squared` grew, and in all later sweeps once the
/// acceleration has diverged. Islands with more than 1000 contacts are swept without this
/// acceleration.
///
/// @param count  number of active contacts
Residuals run_sweeps(ContactProblem& problem, Sweeps& sweeps, std::size_t count,
                     const SweepLimits& limits);

/// Replaces the current impulses of the sweeps by the argument `impulses`.
void set_impulses(Sweeps& sweeps, std::vector<Vector3d> impulses);

} // namespace rigor
