// SPDX-License-Identifier: MIT
// Friction coefficients above 1 are taken as 1.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    Contacts limited = contacts;
    for (BodyContact& c : limited)
        c.friction = std::min(c.friction, 1.0);
    return ContactsAtOnce()(bodies, limited, sweeps);
}

} // namespace rigor
