// SPDX-License-Identifier: MIT
// A contact must see the velocities that the contacts before it changed in the same sweep.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.sees_those_before = false;
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
