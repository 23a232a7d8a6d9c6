// SPDX-License-Identifier: MIT
// Selects the contacts of an island at which an impulse can change the relative velocity, and sets
// their target speeds. Several threads visit ranges of pairs. The list of each range is joined to
// the others in the order of the pairs.
#include "rigid/contact/active_contacts.hpp"

#include "rigid/contact/position_correction.hpp"

namespace rigor {

UninitializedVector<int> activate_contacts(ContactProblem& problem, const Island& island)
{
    const auto activate = [&](std::span<const ContactPair> pairs) {
        UninitializedVector<int> active;
        active.reserve(contact_count(pairs));
        for (const ContactPair& pair : pairs)
            for (int i = pair.first; i < pair.last; ++i) {
                ContactConstraint& c = problem.contacts[i];
                if (!(c.normal_K > 0) || !(c.tangential_K > 0)) continue; // neither body can move
                c.target_speed =
                    c.gap > 0 ? -c.gap / problem.time_step : correction_speed(problem, c);
                if (c.passes_by != 0) c.target_speed -= c.passes_by / problem.time_step;
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
