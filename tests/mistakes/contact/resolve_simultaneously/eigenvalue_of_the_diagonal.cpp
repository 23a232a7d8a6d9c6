// SPDX-License-Identifier: MIT
// λ is an eigenvalue: K may couple the two tangential directions, also on a floor.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.lambda = [](const VisitedContact& c) {
        for (int i = 0; i < 3; ++i)
            if (std::abs(c.n()[i]) == 1) // a floor or a wall
                return std::max(c.K((i + 1) % 3, (i + 1) % 3), c.K((i + 2) % 3, (i + 2) % 3));
        return larger_eigenvalue(c.K, c.n());
    };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
