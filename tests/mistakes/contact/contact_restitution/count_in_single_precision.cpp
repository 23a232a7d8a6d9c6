// SPDX-License-Identifier: MIT
// A float holds whole numbers only up to 2^24, so a larger n is rounded.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

double contact_restitution(int k, int n)
{
    if (n < 1 || k >= n - 1) return 0;
    return (std::max(k, 0) + 1.0) / static_cast<float>(n) - 1;
}

} // namespace rigor
