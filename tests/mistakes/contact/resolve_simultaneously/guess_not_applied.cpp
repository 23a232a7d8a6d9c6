// SPDX-License-Identifier: MIT
// A warm start that only counts has to act on the bodies too.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.start = [](Bodies&, const BodyContact& c) { return c.impulse; };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
