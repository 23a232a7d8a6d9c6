// SPDX-License-Identifier: MIT
// Friction is stepped by λ, which is of K across n; nᵀ K n is too small for a ball.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.lambda = [](const VisitedContact& c) { return c.push_stiffness(); };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
