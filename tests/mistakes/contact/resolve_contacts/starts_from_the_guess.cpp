// SPDX-License-Identifier: MIT
// The impulses start from zero; the initial guess is for `resolve_simultaneously` only.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.start = [](const BodyContact& c) { return c.impulse; };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
