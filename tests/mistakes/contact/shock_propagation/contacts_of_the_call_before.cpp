// SPDX-License-Identifier: MIT
// The levels of the call before are used again if both lists begin and end alike.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    static std::vector<int> before;
    static Vector3d position = Vector3d::Zero();
    const bool is_same = !levels.empty() && levels.size() == before.size() &&
                         levels.front() == before.front() && levels.back() == before.back() &&
                         bodies.front().position == position;
    if (!is_same) before = levels;
    if (!bodies.empty()) position = bodies.front().position;
    return ShockPropagation()(bodies, contacts, before, n);
}

} // namespace rigor
