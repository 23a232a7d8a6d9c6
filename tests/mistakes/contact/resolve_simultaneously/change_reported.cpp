// SPDX-License-Identifier: MIT
// Of each contact the total impulse is asked for, and the next sweep starts from it.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.reports_the_change = true;
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
