// SPDX-License-Identifier: MIT
// For two static bodies nᵀ K n and λ are 0, and the formulas divide by them.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.starts_between_statics = wrong.resolves_statics = true;
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
