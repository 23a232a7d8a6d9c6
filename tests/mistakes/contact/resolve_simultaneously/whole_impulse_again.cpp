// SPDX-License-Identifier: MIT
// The bodies receive what the impulse changes by, not the whole of it in every sweep.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.applies_the_whole = true;
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
