// SPDX-License-Identifier: MIT
// Only the first 2000 contacts are looked at.
#include "formulas/collision.hpp"

namespace rigor {

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    std::optional<int> deepest;
    for (int i = 0; i < std::min(2000, static_cast<int>(contacts.size())); ++i) {
        if (contacts[i].relative_velocity.dot(contacts[i].normal) >= 0) continue;
        if (!deepest || contacts[i].depth > contacts[*deepest].depth) deepest = i;
    }
    return deepest;
}

} // namespace rigor
