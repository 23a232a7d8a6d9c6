// SPDX-License-Identifier: MIT
// (k + 1)/n is an integer division, which gives 0 until the last iteration.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

double contact_restitution(int k, int n)
{
    if (n < 1 || k >= n - 1) return 0;
    return (std::max(k, 0) + 1) / n - 1;
}

} // namespace rigor
