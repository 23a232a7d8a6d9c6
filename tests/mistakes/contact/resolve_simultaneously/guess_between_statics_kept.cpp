// SPDX-License-Identifier: MIT
// Two static bodies have no impulse between them; here they keep the initial guess.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.starts_between_statics = true;
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
