// SPDX-License-Identifier: MIT
// Friction divides by nᵀ K n, not by λ of K in the tangent plane: too small a number for a ball.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.lambda = [](const VisitedContact& c) { return c.push_stiffness(); };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
