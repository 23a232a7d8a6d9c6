// SPDX-License-Identifier: MIT
// A restitution from 0.9 down to 0 throws apart what rests.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

double contact_restitution(int k, int n)
{
    if (n < 1 || k >= n - 1) return 0;
    return 1 - (std::max(k, 0) + 1.0) / n;
}

} // namespace rigor
