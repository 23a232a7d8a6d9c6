// SPDX-License-Identifier: MIT
// The impulses of these contacts start from zero, not from a guess for another formula.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.start = [](const BodyContact& c) { return c.impulse; };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
