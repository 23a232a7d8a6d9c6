// SPDX-License-Identifier: MIT
// Selects the contacts of an island at which an impulse can change the relative velocity, and sets
// their target speeds. Several threads visit ranges of pairs. The lists of all ranges are joined in
// the order of the pairs.
#include "rigid/contact/active_contacts.hpp"

#include "rigid/contact/position_correction.hpp"

namespace rigor {

namespace {

// A contact of a pile counts as closed if its gap is at most this fraction of the contact's radius
// (`ContactConstraint::radius`). An overlap of the same size is left uncorrected by
// `position_corrections`. Where two faces rest on each other, the gaps at their corners differ by
// micrometers. If each contact had to close its own gap in this step, no motion would satisfy
// all of them. The sweeps would move the load from corner to corner without end, and the pile would
// creep and never fall asleep.
constexpr double closed_gap = 2 * penetration_slop;

// The least v·n that the contact must have after the contact stage, without the part by
// `gap_correction` [m/s]. Across a gap, the bodies may approach until they touch at the end of the
// step.
double target_speed_of(const ContactProblem& problem, const ContactConstraint& c, bool is_in_pile)
{
    if (c.gap <= 0) return correction_speed(problem, c);
    return is_in_pile && c.gap <= closed_gap * c.radius ? 0 : -c.gap / problem.time_step;
}

} // namespace

UninitializedVector<int> activate_contacts(ContactProblem& problem, const Island& island)
{
    const bool is_in_pile = is_pile(island);
    const auto activate = [&](std::span<const ContactPair> pairs) {
        UninitializedVector<int> active;
        active.reserve(contact_count(pairs));
        for (const ContactPair& pair : pairs)
            for (int i = pair.first; i < pair.last; ++i) {
                ContactConstraint& c = problem.contacts[i];
                if (!(c.normal_K > 0) || !(c.tangential_K > 0)) continue; // neither body can move
                c.target_speed = target_speed_of(problem, c, is_in_pile);
                if (c.gap_correction != 0) c.target_speed -= c.gap_correction / problem.time_step;
                active.push_back(i);
            }
        return active;
    };
    constexpr std::size_t grain_size = 256; // a thread takes at least this many pairs at a time
    const std::span<const ContactPair> pairs = island.pairs;
    return concatenate_ranges(*problem.pool, pairs.size(), grain_size,
                              [&](std::size_t first, std::size_t last) {
                                  return activate(pairs.subspan(first, last - first));
                              });
}

} // namespace rigor
