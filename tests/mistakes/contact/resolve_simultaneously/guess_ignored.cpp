// SPDX-License-Identifier: MIT
// The impulses must start from the initial guess, not from zero.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.start = [](Bodies&, const BodyContact&) -> Vector3d { return Vector3d::Zero(); };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
