// SPDX-License-Identifier: MIT
// The depth 0 counts as deeper than the depth -0.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    std::optional<int> deepest;
    double depth = 0;
    for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
        const ContactPoint& contact = contacts[i];
        if (contact.relative_velocity.dot(contact.normal) >= 0) continue;
        const bool is_as_deep =
            contact.depth == depth && std::signbit(contact.depth) >= std::signbit(depth);
        if (deepest && (contact.depth < depth || is_as_deep)) continue;
        deepest = i;
        depth = contact.depth;
    }
    return deepest;
}

} // namespace rigor
