// SPDX-License-Identifier: MIT
// A first estimate of the impulses of an island that rests on static bodies. For each contact that
// carries weight, the code finds which of its bodies rests on the other. Then it visits the bodies
// from the highest to the lowest. Each body passes its own weight and the load on it to the
// contacts below it, in equal parts.
#include "rigid/contact/load_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// A body, the body that it rests on, and the contact between them.
struct Support {
    int upper = 0, lower = 0, contact = 0;
};

std::vector<Support> supports_of(const ContactProblem& problem, std::span<const int> active,
                                 const Vector3d& up)
{
    std::vector<Support> supports;
    for (int i : active) {
        const ContactConstraint& c = problem.contacts[i];
        const double lift = c.normal.dot(up);
        const double v_n = problem.velocity_at(c, c.point).dot(c.normal);
        if (std::abs(lift) < least_lift ||
            problem.predicted_gap(c, v_n) > nearly_touching_gap * c.radius)
            continue;
        const Support support =
            lift > 0 ? Support{c.body1, c.body2, i} : Support{c.body2, c.body1, i};
        if (!problem.bodies[support.upper].is_static()) supports.push_back(support);
    }
    return supports;
}

// Sets the initial impulse of the contact in `by` so that the upper body gets the impulse `push`
// [N s]. If this impulse lies outside the friction cone, only its normal part is taken.
void support(ContactProblem& problem, const Support& by, const Vector3d& push)
{
    ContactConstraint& c = problem.contacts[by.contact];
    Vector3d j = by.upper == c.body1 ? push : Vector3d(-push);
    const double j_n = j.dot(c.normal);
    if ((j - j_n * c.normal).norm() > c.friction * j_n) j = j_n * c.normal;
    c.initial_impulse = j;
}

} // namespace

void estimate_loads(ContactProblem& problem, const Island& island, std::span<const int> active)
{
    const double g = problem.settings.gravity.norm();
    if (g == 0) return;
    const Vector3d up = problem.up();
    std::vector<Support> supports = supports_of(problem, active, up);
    const bool is_grounded = std::any_of(supports.begin(), supports.end(), [&](const Support& s) {
        return problem.bodies[s.lower].is_static();
    });
    if (!is_grounded) return;

    const auto height = [&](int body) { return up.dot(problem.bodies[body].position); };
    std::stable_sort(supports.begin(), supports.end(), [&](const Support& a, const Support& b) {
        const double p = height(a.upper), q = height(b.upper);
        return p > q || (p == q && a.upper < b.upper);
    });
    // The weight of each body plus the load on it, times the time step [N s].
    std::vector<double> loads(problem.bodies.size(), 0.0);
    for (int i : island.bodies)
        loads[i] = g * problem.time_step / problem.bodies[i].inverse_mass;
    for (auto first = supports.begin(); first != supports.end();) {
        const auto last = std::find_if(first, supports.end(),
                                       [&](const Support& s) { return s.upper != first->upper; });
        const double share = loads[first->upper] / static_cast<double>(last - first);
        for (; first != last; ++first) {
            support(problem, *first, share * up);
            loads[first->lower] += share;
        }
    }
}

} // namespace rigor
