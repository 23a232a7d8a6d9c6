// SPDX-License-Identifier: MIT
// The contacts are visited from the deepest on, not in the order of the list.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.order = [](const Contacts& listed) {
        std::vector<int> order(listed.size());
        std::iota(order.begin(), order.end(), 0);
        return order;
    };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
