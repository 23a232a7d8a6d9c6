// SPDX-License-Identifier: MIT
// Equally deep contacts are visited in the order of the list, not in that of their bodies.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.order = [](const Contacts& listed) {
        std::vector<int> order(listed.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
            const BodyContact &first = listed[a], &second = listed[b];
            if (first.depth != second.depth) return first.depth > second.depth;
            return first.body1 < second.body1;
        });
        return order;
    };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
