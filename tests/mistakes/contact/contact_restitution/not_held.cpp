// SPDX-License-Identifier: MIT
// Outside of 0 ≤ k < n the value must be clamped; here it rises above 0 or falls below -1.
#include "formulas/contact.hpp"

namespace rigor {

double contact_restitution(int k, int n)
{
    if (n < 1) return 0;
    return (k + 1.0) / n - 1;
}

} // namespace rigor
