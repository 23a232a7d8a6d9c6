// SPDX-License-Identifier: MIT
// Contacts that approach slower than 1e-6 m/s are passed over.
#include "formulas/collision.hpp"

namespace rigor {

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    std::optional<int> deepest;
    for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
        if (contacts[i].relative_velocity.dot(contacts[i].normal) > -1e-6) continue;
        if (!deepest || contacts[i].depth > contacts[*deepest].depth) deepest = i;
    }
    return deepest;
}

} // namespace rigor
