// SPDX-License-Identifier: MIT
// At most 10000 sweeps are made, although `sweeps` may be larger.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    return ContactsAtOnce()(bodies, contacts, std::min(sweeps, 10'000));
}

} // namespace rigor
