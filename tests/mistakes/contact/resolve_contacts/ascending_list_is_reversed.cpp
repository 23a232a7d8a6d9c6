// SPDX-License-Identifier: MIT
// A list that is sorted the other way around is reversed, and with it the order of equal depths.
#include "mistakes/contact/resolve_contacts.hpp"

#include <algorithm>

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime resolve;
    resolve.order = [](const Contacts& all) {
        std::vector<int> order = by_depth(all);
        const auto is_shallower = [](const BodyContact& a, const BodyContact& b) {
            return a.depth < b.depth;
        };
        if (std::is_sorted(all.begin(), all.end(), is_shallower))
            for (std::size_t i = 0; i < order.size(); ++i)
                order[i] = static_cast<int>(order.size() - 1 - i);
        return order;
    };
    return resolve(bodies, contacts, n);
}

} // namespace rigor
