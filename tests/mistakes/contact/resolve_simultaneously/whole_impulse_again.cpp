// SPDX-License-Identifier: MIT
// Each sweep must apply the change of the impulse, not the whole impulse again.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.applies_the_whole = true;
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
