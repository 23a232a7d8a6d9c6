// SPDX-License-Identifier: MIT
// Friction divides by λ, of K in the tangent plane; nᵀ K n is too small for a ball.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.lambda = [](const VisitedContact& c) { return c.push_stiffness(); };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
