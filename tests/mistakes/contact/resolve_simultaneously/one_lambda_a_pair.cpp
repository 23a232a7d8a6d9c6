// SPDX-License-Identifier: MIT
// λ depends on the point of the contact, so a pair of bodies has one for each of its points.
#include "mistakes/contact/resolve_simultaneously.hpp"

#include <map>
#include <tuple>

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    std::map<std::tuple<int, int, double, double>, double> first; // by bodies and normal
    wrong.lambda = [&](const VisitedContact& c) {
        return first
            .try_emplace({c.contact.body1, c.contact.body2, c.n().x(), c.n().y()},
                         larger_eigenvalue(c.K, c.n()))
            .first->second;
    };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
