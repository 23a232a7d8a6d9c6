// SPDX-License-Identifier: MIT
// Between two static bodies nᵀ K n and λ are 0.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.starts_between_statics = wrong.resolves_statics = true;
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
