// SPDX-License-Identifier: MIT
// Repeats sweeps over an island's contacts until they change nothing that matters.
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// Limits at which a run of sweeps ends.
struct SweepLimits {
    int most_sweeps = 0;
    double negligible_change = 0; // [m/s]
};

/// Convergence of a run of sweeps: the largest change in the first and in the last sweep [m/s].
struct Residuals {
    double first = 0, last = 0;
    int sweeps = 0;
    bool has_converged = false; // whether the last sweep changed nothing that matters

    /// An estimate of the sum of all changes that further sweeps would make [m/s], if each sweep
    /// reduces the change as much as these sweeps did on average. Under a heavy body the change of
    /// one sweep is a small part of this sum: a ten millionth of it at a mass ratio of 1e7. The
    /// assumed decay has a lower limit, so that a rounding error, which does not decay, adds up to
    /// little.
    double missing() const;
};

/// Sweeps until the changes are negligible or the limit is reached. After each sweep the impulses
/// also move on in the direction of the previous sweeps, as long as this helps (nonlinear conjugate
/// gradients). With the changes by the sweep as `steps`: impulses += β directions, directions =
/// steps + β directions, in this order.
Residuals run_sweeps(ContactProblem& problem, Sweeps& sweeps, std::size_t count,
                     const SweepLimits& limits);

/// Changes the impulses of the sweeps to the given ones.
void set_impulses(Sweeps& sweeps, std::vector<Vector3d> impulses);

} // namespace rigor
