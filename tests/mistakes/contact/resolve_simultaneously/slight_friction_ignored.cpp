// SPDX-License-Identifier: MIT
// Friction coefficients below a millionth are taken as 0.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    Contacts limited = contacts;
    for (BodyContact& c : limited)
        if (c.friction < 1e-6) c.friction = 0;
    return ContactsAtOnce()(bodies, limited, sweeps);
}

} // namespace rigor
