// SPDX-License-Identifier: MIT
// The collision stage takes the pairs in the order of their bodies, and not in the order of their
// impacts. So a bounce may be taken before one that comes first, and may prevent it. The times of
// impact, as they are predicted from the start of the step, show this.
#include "rigid/step/substeps/passed_contact.hpp"

#include "rigid/step/impact.hpp"
#include "rigid/step/substeps/divisions.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace rigor {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

bool is_moved_bounce(const Island& island, const ContactConstraint& c)
{
    return std::any_of(
        island.moved_bounces.begin(), island.moved_bounces.end(),
        [&](const ContactRecord& r) { return r.body1 == c.body1 && r.body2 == c.body2; });
}

// Whether a contact of the pair is known to stay open in free flight, as between balls that fly
// past each other (`gap_correction`).
bool flies_past(const ContactProblem& problem, const ContactPair& pair)
{
    return std::any_of(problem.contacts.begin() + pair.first, problem.contacts.begin() + pair.last,
                       [](const ContactConstraint& c) { return c.gap_correction > 0; });
}

} // namespace

double closing_of_passed_contact(const World& world, const ContactProblem& problem,
                                 const Island& island)
{
    std::map<int, double> last_bounce; // the predicted time for each body that can move [s]
    for (const ContactPair& pair : island.pairs) {
        const ContactConstraint& c = problem.contacts[pair.first];
        if (!bounced(problem, pair) && !is_moved_bounce(island, c)) continue;
        const double time = time_of_impact(world, problem, pair);
        for (const int i : {c.body1, c.body2})
            if (!problem.bodies[i].is_static() && time < never)
                last_bounce[i] = std::max(last_bounce[i], time);
    }
    double first = never;
    if (last_bounce.empty()) return first;
    for (const ContactPair& pair : island.pairs) {
        const ContactConstraint& c = problem.contacts[pair.first];
        const auto later = [&](int i) {
            const auto found = last_bounce.find(i);
            return found == last_bounce.end() ? 0.0 : found->second;
        };
        const double bounce = std::max(later(c.body1), later(c.body2));
        if (bounce == 0 || bounced(problem, pair) || carries_load(problem, pair) ||
            is_moved_bounce(island, c) || flies_past(problem, pair))
            continue;
        const double time = time_of_impact(world, problem, pair);
        if (time > 0 && time + alone_in_step * problem.time_step < bounce)
            first = std::min(first, time);
    }
    return first;
}

} // namespace rigor
