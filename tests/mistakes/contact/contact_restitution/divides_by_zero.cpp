// SPDX-License-Identifier: MIT
// The number of iterations n can be 0, and the formula divides by it.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

double contact_restitution(int k, int n)
{
    return std::min(0.0, (std::max(k, 0) + 1.0) / n - 1);
}

} // namespace rigor
