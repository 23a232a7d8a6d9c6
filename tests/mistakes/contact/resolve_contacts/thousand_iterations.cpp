// SPDX-License-Identifier: MIT
// At most 1000 iterations are made, although n may be larger.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    return ContactsOneAtATime()(bodies, contacts, std::min(n, 1000));
}

} // namespace rigor
