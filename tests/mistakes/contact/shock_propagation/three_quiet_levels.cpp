// SPDX-License-Identifier: MIT
// It stops after three levels in a row that needed no impulse, though bodies above them may fall.
#include "mistakes/contact/shock_propagation.hpp"

#include <map>

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    const std::vector<Vector3d> impulses = ShockPropagation()(bodies, contacts, levels, n).impulses;
    std::map<int, bool> is_pushed; // for each level with a contact
    for (std::size_t i = 0; i < contacts.size(); ++i)
        is_pushed[std::max(levels[contacts[i].body1], levels[contacts[i].body2])] |=
            !impulses[i].isZero(0);
    is_pushed.erase(0);
    ShockPropagation wrong;
    wrong.order = [&](int) {
        std::vector<int> order;
        int quiet = 0;
        for (const auto& [level, pushed] : is_pushed) {
            order.push_back(level);
            quiet = pushed ? 0 : quiet + 1;
            if (quiet == 3) break;
        }
        return order;
    };
    return wrong(bodies, contacts, levels, n);
}

} // namespace rigor
