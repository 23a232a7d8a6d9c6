// SPDX-License-Identifier: MIT
// The sort does not keep the order of equally deep contacts. It shows only in long lists.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.order = [](const Contacts& listed) {
        std::vector<int> order(listed.size());
        std::iota(order.begin(), order.end(), 0);
        std::sort(order.begin(), order.end(),
                  [&](int a, int b) { return listed[a].depth > listed[b].depth; });
        return order;
    };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
