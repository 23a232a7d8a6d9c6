// SPDX-License-Identifier: MIT
// With k/n - 1 instead of (k + 1)/n - 1 the last iteration still has restitution -1/n, not 0.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

double contact_restitution(int k, int n)
{
    if (n < 1 || k >= n) return 0;
    return std::max(k, 0) / static_cast<double>(n) - 1;
}

} // namespace rigor
