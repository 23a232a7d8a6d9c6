// SPDX-License-Identifier: MIT
// Iterations outside of 0 … n-1 go on along the line, to ε > 0 and below -1.
#include "formulas/contact.hpp"

namespace rigor {

double contact_restitution(int k, int n)
{
    if (n < 1) return 0;
    return (k + 1.0) / n - 1;
}

} // namespace rigor
