// SPDX-License-Identifier: MIT
// Depths are compared as floats, in which many of them are equal.
#include "formulas/collision.hpp"

namespace rigor {

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    std::optional<int> deepest;
    float depth = 0;
    for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
        const ContactPoint& contact = contacts[i];
        if (contact.relative_velocity.dot(contact.normal) >= 0) continue;
        if (deepest && static_cast<float>(contact.depth) <= depth) continue;
        deepest = i;
        depth = static_cast<float>(contact.depth);
    }
    return deepest;
}

} // namespace rigor
