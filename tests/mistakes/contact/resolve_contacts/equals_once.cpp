// SPDX-License-Identifier: MIT
// Among contacts of the same bodies at the same point, only the first one is resolved.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.order = [](const Contacts& all) {
        std::vector<int> order;
        for (int i : by_depth(all)) {
            bool is_known = false;
            for (int k : order)
                is_known |= all[k].point == all[i].point && all[k].body1 == all[i].body1 &&
                            all[k].body2 == all[i].body2;
            if (!is_known) order.push_back(i);
        }
        return order;
    };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
