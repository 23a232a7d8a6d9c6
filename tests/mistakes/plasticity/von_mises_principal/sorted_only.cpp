// SPDX-License-Identifier: MIT
// The largest minus the smallest, trusting that the first is the largest.
#include "formulas/plasticity.hpp"

namespace rigor {

double von_mises_principal(double stress1, double stress2, double stress3)
{
    return stress1 - stress3;
}

} // namespace rigor
