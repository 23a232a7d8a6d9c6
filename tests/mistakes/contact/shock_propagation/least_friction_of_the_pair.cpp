// SPDX-License-Identifier: MIT
// All contacts of the same two bodies get the smallest of their coefficients of friction.
#include "mistakes/contact/shock_propagation.hpp"

#include <algorithm>

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    Contacts changed = contacts;
    for (BodyContact& c : changed)
        for (const BodyContact& other : contacts)
            if (c.body1 == other.body1 && c.body2 == other.body2)
                c.friction = std::min(c.friction, other.friction);
    const ShockPropagation wrong;
    return wrong(bodies, changed, levels, n);
}

} // namespace rigor
