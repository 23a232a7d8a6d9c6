// SPDX-License-Identifier: MIT
// Each level gets n iterations, not at most ten.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ShockPropagation wrong;
    wrong.iterations = [](int asked) { return std::min(asked, 10); };
    return wrong(bodies, contacts, levels, n);
}

} // namespace rigor
