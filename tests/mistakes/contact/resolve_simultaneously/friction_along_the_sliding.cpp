// SPDX-License-Identifier: MIT
// The sign of friction is wrong: it acts against the sliding.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.friction = [](const Vector3d& v_T, double lambda) -> Vector3d { return v_T / lambda; };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
