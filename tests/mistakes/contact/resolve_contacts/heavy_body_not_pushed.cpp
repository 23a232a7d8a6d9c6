// SPDX-License-Identifier: MIT
// A body that is far heavier than the other one gets no impulse, so momentum is lost.
#include "mistakes/contact/resolve_contacts.hpp"

#include <algorithm>

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.push = [](Bodies& all, const BodyContact& c, const Vector3d& j) {
        const Bodies before = all;
        apply(all, c, j);
        const double light = std::max(all[c.body1].inverse_mass, all[c.body2].inverse_mass);
        for (const int i : {c.body1, c.body2})
            if (all[i].inverse_mass <= 1e-8 * light) all[i] = before[i];
    };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
