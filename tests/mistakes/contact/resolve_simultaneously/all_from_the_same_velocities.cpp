// SPDX-License-Identifier: MIT
// A contact has to see what those before it in the same sweep did.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.sees_those_before = false;
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
