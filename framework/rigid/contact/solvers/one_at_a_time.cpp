// SPDX-License-Identifier: MIT
// Resolves contacts one at a time, by the formulas of topic `contact` (Guendelman, Bridson and
// Fedkiw 2003). First `resolve_contacts` runs. With shock propagation, each body then gets a level,
// and the contacts are resolved level by level, while the bodies of lower levels keep their
// velocities.
#include "rigid/contact/solvers/one_at_a_time.hpp"

#include "formulas/contact.hpp"
#include "rigid/contact/load_estimate.hpp"
#include "rigid/contact/local_island.hpp"

#include <algorithm>
#include <stdexcept>

namespace rigor {

namespace {

// The number of iterations of `resolve_contacts`, and also of `shock_propagation`, as in the paper
// (Guendelman, Bridson and Fedkiw 2003).
constexpr int iterations = 10;
// In one iteration, a light body passes on only a small part of the load of a heavy body.
// Therefore, before shock propagation, `resolve_contacts` runs again from the same start with
// `growth` times as many iterations. This is repeated until the fastest approach is at most
// `enough_share` of that at the start. In such a run, the number of iterations times the number of
// contacts is at most `most_visits`. With ten iterations alone, the plank of a seesaw passed on
// only half the weight of a heavy body.
constexpr double enough_share = 0.02;
constexpr int growth = 4, most_visits = 4000;

// For each body, the bodies on which it rests: their contacts can lift it (`least_lift`).
std::vector<std::vector<int>> supports(const ContactProblem& problem, const LocalIsland& local)
{
    std::vector<std::vector<int>> rests_on(local.bodies.size());
    for (const BodyContact& c : local.contacts) {
        const double lift = c.normal.dot(problem.up());
        if (lift > least_lift) rests_on[c.body1].push_back(c.body2);
        if (lift < -least_lift) rests_on[c.body2].push_back(c.body1);
    }
    return rests_on;
}

// The largest amount by which v·n of a contact is below its `separation_speed`; 0 if there is no
// such contact [m/s].
double fastest_approach(const std::vector<Body>& bodies, const std::vector<BodyContact>& contacts)
{
    double fastest = 0;
    for (const BodyContact& c : contacts) {
        const Body &b1 = bodies[c.body1], &b2 = bodies[c.body2];
        const Vector3d v = b1.velocity + b1.angular_velocity.cross(c.point - b1.position) -
                           b2.velocity - b2.angular_velocity.cross(c.point - b2.position);
        fastest = std::max(fastest, c.separation_speed - v.dot(c.normal));
    }
    return fastest;
}

ContactResult resolved(ContactProblem& problem, const LocalIsland& local, int n)
{
    ContactResult result = resolve_contacts(local.bodies, local.contacts, n);
    check_size(local, result, "resolve_contacts");
    problem.counters->contact_sweeps += n;
    return result;
}

} // namespace

void resolve_one_at_a_time(ContactProblem& problem, std::span<const int> active, bool shock)
{
    const LocalIsland local = local_island(problem, active);
    ContactResult result = resolved(problem, local, iterations);
    if (shock) { // a load has to reach the ground now: `shock_propagation` pushes no lower body
        const double enough = enough_share * fastest_approach(local.bodies, local.contacts);
        const int most = most_visits / static_cast<int>(active.size());
        for (int n = growth * iterations;
             n <= most && fastest_approach(result.bodies, local.contacts) > enough; n *= growth)
            result = resolved(problem, local, n);
    }
    take_result(problem, local, active, result, "resolve_contacts");
    if (!shock) return;

    std::vector<bool> is_static;
    for (const Body& body : local.bodies)
        is_static.push_back(body.is_static());
    const std::vector<int> levels = contact_levels(supports(problem, local), is_static);
    if (levels.size() != local.bodies.size())
        throw std::out_of_range("contact_levels returned " + std::to_string(levels.size()) +
                                " levels for " + std::to_string(local.bodies.size()) + " bodies");
    const ContactResult pushed =
        shock_propagation(result.bodies, local.contacts, levels, iterations);
    check_size(local, pushed, "shock_propagation");
    const std::vector<Vector3d> before = result.impulses;
    result = pushed;
    for (std::size_t k = 0; k < before.size(); ++k)
        result.impulses[k] += before[k];
    take_result(problem, local, active, result, "shock_propagation");
    problem.counters->contact_sweeps += iterations;
}

} // namespace rigor
