// SPDX-License-Identifier: MIT
// Only the hundred deepest contacts are resolved.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.order = [](const Contacts& all) {
        std::vector<int> order = by_depth(all);
        if (order.size() > 100) order.resize(100);
        return order;
    };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
