// SPDX-License-Identifier: MIT
// The contact stage of an island. The world's contact method solves the active contacts. In a world
// without gravity, the target speeds also correct penetration. Then the change of the kinetic
// energy decides whether the result is kept; if not, the island is solved again without this
// correction.
#include "rigid/contact/resting_contact.hpp"

#include "rigid/contact/active_contacts.hpp"
#include "rigid/contact/driven_bodies.hpp"
#include "rigid/contact/load_estimate.hpp"
#include "rigid/contact/solvers/island_solver.hpp"
#include "rigid/contact/solvers/one_at_a_time.hpp"

#include <algorithm>
#include <limits>

namespace rigor {

namespace {

void solve(ContactProblem& problem, const Island& island, std::span<const int> active)
{
    switch (problem.settings.contact_method) {
    case ContactMethod::one_at_a_time:
        return resolve_one_at_a_time(problem, active, false);
    case ContactMethod::shock_propagation:
        return resolve_one_at_a_time(problem, active, true);
    case ContactMethod::built_in:
    case ContactMethod::simultaneous:
        break;
    }
    const bool is_warm = std::any_of(active.begin(), active.end(), [&](int i) {
        return !problem.contacts[i].initial_impulse.isZero(0);
    });
    if (!is_warm) estimate_loads(problem, island, active);
    solve_island(problem, island, active);
}

// `all`: kinetic energy of an island in a frame with the velocity V. `inner`: the part of it that
// belongs to the motion relative to the island's center of mass [J].
struct Energy {
    double all = 0, inner = 0;
};

Energy kinetic_energy(const ContactProblem& problem, const Island& island, const Vector3d& V)
{
    double energy = 0, M = 0;
    Vector3d P(0, 0, 0);
    for (int i : island.bodies) {
        const Body& b = problem.bodies[i];
        const double m = 1 / b.inverse_mass;
        energy += kinetic_energy_of(b, V);
        P += m * (b.velocity - V);
        M += m;
    }
    return {energy, energy - P.squaredNorm() / (2 * M)};
}

void resolve(ContactProblem& problem, const Island& island)
{
    const UninitializedVector<int> active = activate_contacts(problem, island);
    if (active.empty()) return;
    const bool corrects = std::any_of(active.begin(), active.end(),
                                      [&](int i) { return problem.contacts[i].target_speed > 0; });
    if (!corrects) return solve(problem, island, active);

    // A target speed above 0 corrects penetration, but adds energy. The result is kept in two
    // cases. Either the kinetic energy of the island does not grow, or it grows by more than
    // `before.inner`, so the bodies hardly moved relative to each other before. Otherwise the
    // island is solved again without the correction, which waits for a later step.
    constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();
    const std::vector<Body> bodies = problem.bodies_of(island);
    const Vector3d V = problem.grounds_of(island).front().velocity;
    const Energy before = kinetic_energy(problem, island, V);
    solve(problem, island, active);
    const double gain = kinetic_energy(problem, island, V).all - before.all;
    if (gain <= rounding * before.all || gain > before.inner) return;
    for (std::size_t k = 0; k < bodies.size(); ++k)
        problem.bodies[island.bodies[k]] = bodies[k];
    for (int i : active) {
        ContactConstraint& c = problem.contacts[i];
        c.target_speed = std::min(c.target_speed, 0.0);
        c.contact_impulse.setZero();
    }
    solve(problem, island, active);
}

} // namespace

void process_contact(ContactProblem& problem, const Island& island,
                     std::span<const Body> before_forces)
{
    set_velocities_at_end(problem, island, before_forces);
    resolve(problem, island);
    reset_velocities(problem, island);
}

} // namespace rigor
