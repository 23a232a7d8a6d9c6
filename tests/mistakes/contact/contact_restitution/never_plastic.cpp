// SPDX-License-Identifier: MIT
// The first iteration counts as 1: with k/n - 1 the last one still leaves 1/n of the approach.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

double contact_restitution(int k, int n)
{
    if (n < 1 || k >= n) return 0;
    return std::max(k, 0) / static_cast<double>(n) - 1;
}

} // namespace rigor
