// SPDX-License-Identifier: MIT
// Equal contacts are sorted by an algorithm that keeps their order only in short lists.
#include "formulas/collision.hpp"

#include <algorithm>

namespace rigor {

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    std::vector<int> order;
    for (int i = 0; i < static_cast<int>(contacts.size()); ++i)
        if (contacts[i].relative_velocity.dot(contacts[i].normal) < 0) order.push_back(i);
    if (order.empty()) return std::nullopt;
    std::sort(order.begin(), order.end(),
              [&](int i, int j) { return contacts[i].depth > contacts[j].depth; });
    return order.front();
}

} // namespace rigor
