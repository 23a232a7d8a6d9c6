// SPDX-License-Identifier: MIT
// The sign is wrong: a restitution that falls from nearly 1 to 0 makes resting bodies bounce.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

double contact_restitution(int k, int n)
{
    if (n < 1 || k >= n - 1) return 0;
    return 1 - (std::max(k, 0) + 1.0) / n;
}

} // namespace rigor
