// SPDX-License-Identifier: MIT
// The result is the total impulse of each contact, and the next sweep starts from it.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.reports_the_change = true;
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
