// SPDX-License-Identifier: MIT
// A contact whose bodies do not touch yet never has to separate, whatever its separation speed is.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    Contacts changed = contacts;
    for (BodyContact& c : changed)
        if (c.depth < 0) c.separation_speed = std::min(0.0, c.separation_speed);
    return ShockPropagation()(bodies, changed, levels, n);
}

} // namespace rigor
