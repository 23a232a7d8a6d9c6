// SPDX-License-Identifier: MIT
// A contact with v·n = 0 does not approach and must be skipped.
#include "formulas/collision.hpp"

namespace rigor {

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    std::optional<int> deepest;
    for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
        const ContactPoint& contact = contacts[i];
        if (contact.relative_velocity.dot(contact.normal) > 0) continue;
        if (!deepest || contact.depth > contacts[*deepest].depth) deepest = i;
    }
    return deepest;
}

} // namespace rigor
