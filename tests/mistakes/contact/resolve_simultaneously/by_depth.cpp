// SPDX-License-Identifier: MIT
// The sweeps visit the contacts in the order of the list, not by depth.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.order = by_depth;
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
