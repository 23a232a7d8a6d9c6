// SPDX-License-Identifier: MIT
// No iterations at all, n = 0, is asked for too.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

double contact_restitution(int k, int n)
{
    return std::min(0.0, (std::max(k, 0) + 1.0) / n - 1);
}

} // namespace rigor
