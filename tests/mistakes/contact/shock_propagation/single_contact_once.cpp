// SPDX-License-Identifier: MIT
// A level with a single contact needs its n iterations too, where K couples normal and tangent.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ShockPropagation wrong;
    int level = 0; // the level that is being resolved
    wrong.iterations = [&](int asked) {
        ++level;
        const auto is_here = [&](const BodyContact& c) {
            return std::max(levels[c.body1], levels[c.body2]) == level;
        };
        return std::count_if(contacts.begin(), contacts.end(), is_here) == 1 ? std::min(asked, 1)
                                                                             : asked;
    };
    return wrong(bodies, contacts, levels, n);
}

} // namespace rigor
