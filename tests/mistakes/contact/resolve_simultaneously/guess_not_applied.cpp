// SPDX-License-Identifier: MIT
// The initial guess must also be applied to the bodies, not only added to the impulses.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.start = [](Bodies&, const BodyContact& c) { return c.impulse; };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
