// SPDX-License-Identifier: MIT
// Sweeps that are accelerated by nonsmooth nonlinear conjugate gradients (Silcowitz-Hansen, Niebe
// and Erleben 2010). After each sweep, the impulses also move along a search direction, which
// combines the changes of the sweeps so far; the comment of `run_sweeps` has the formula. If the
// changes grow too much (`divergence`), the rest of the run has no acceleration.
#include "rigid/contact/solvers/run_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

// Islands with more contacts than this are swept without acceleration, because plain sweeps reduce
// the error more in the same time. Chosen by trial; `bench pile` has islands with more contacts,
// and `bench contact` has stacks with fewer.
constexpr std::size_t many_contacts = 1000;
// The acceleration counts as diverging if the change by a sweep (`SweepProgress::change`) exceeds
// this many times the smallest change so far. Even in sweeps that converge, the change may grow a
// little. The factor was chosen by trial.
constexpr double divergence = 2;
constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();

} // namespace

double Residuals::missing() const
{
    // The estimate assumes that ln(residual) falls by at least this much in each sweep. This avoids
    // a division by 0 if the sweeps did not reduce the residual.
    constexpr double slowest_decay = 1e-7;
    return last / std::max(slowest_decay, std::log(first / last) / sweeps);
}

Residuals run_sweeps(ContactProblem& problem, Sweeps& sweeps, std::size_t count,
                     const SweepLimits& limits)
{
    Residuals residuals;
    double before = 0, smallest = std::numeric_limits<double>::infinity();
    const bool is_large = count > many_contacts;
    std::vector<Vector3d> steps(count, Vector3d::Zero());
    std::vector<Vector3d> directions; // search directions; empty until the first sweep is done
    bool diverges = false;            // whether the acceleration diverges, see `divergence`
    for (int i = 1; i <= limits.most_sweeps; ++i) {
        const SweepProgress progress = sweeps.sweep(steps);
        ++problem.counters->contact_sweeps;
        residuals.last = progress.change;
        residuals.sweeps = i;
        if (i == 1) residuals.first = progress.change;
        residuals.has_converged =
            progress.change <= rounding * progress.total + limits.negligible_change;
        if (i == limits.most_sweeps) break;
        if (residuals.has_converged && problem.settings.optimisations.early_exit) {
            ++problem.counters->early_exits;
            break;
        }
        diverges |= progress.change > divergence * smallest;
        smallest = std::min(smallest, progress.change);
        if (is_large) continue;
        const bool slows_down = before > 0 && progress.squared <= before && !diverges;
        // With β = 0 the next search direction does not depend on the previous one.
        const double beta = slows_down ? progress.squared / before : 0;
        before = progress.squared;
        directions.resize(count, Vector3d::Zero());
        for (std::size_t k = 0; k < count; ++k) {
            const Vector3d more = beta * directions[k];
            directions[k] = steps[k] + more;
            steps[k] = more;
        }
        if (beta > 0) sweeps.add(steps);
    }
    return residuals;
}

void set_impulses(Sweeps& sweeps, std::vector<Vector3d> impulses)
{
    const std::vector<Vector3d> here = sweeps.impulses();
    for (std::size_t k = 0; k < here.size(); ++k)
        impulses[k] -= here[k];
    sweeps.add(impulses);
}

} // namespace rigor
