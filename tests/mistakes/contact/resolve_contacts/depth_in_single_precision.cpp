// SPDX-License-Identifier: MIT
// Depths are compared in single precision.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.order = [](const Contacts& all) {
        Contacts rounded = all;
        for (BodyContact& c : rounded)
            c.depth = static_cast<float>(c.depth);
        return by_depth(rounded);
    };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
