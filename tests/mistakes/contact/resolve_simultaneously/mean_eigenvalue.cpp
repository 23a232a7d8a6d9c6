// SPDX-License-Identifier: MIT
// λ is the larger of the two eigenvalues in the tangent plane, not their mean.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.lambda = [](const VisitedContact& c) { return (c.K.trace() - c.push_stiffness()) / 2; };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
