// SPDX-License-Identifier: MIT
// The search begins with the depth -1, so contacts farther apart than that are never found.
#include "formulas/collision.hpp"

namespace rigor {

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    std::optional<int> deepest;
    double depth = -1;
    for (int i = 0; i < static_cast<int>(contacts.size()); ++i)
        if (contacts[i].relative_velocity.dot(contacts[i].normal) < 0 &&
            contacts[i].depth > depth) {
            deepest = i;
            depth = contacts[i].depth;
        }
    return deepest;
}

} // namespace rigor
