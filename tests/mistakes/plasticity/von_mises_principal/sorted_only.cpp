// SPDX-License-Identifier: MIT
// The difference of the first and the last stress is used, as if there were no stress between them.
#include "formulas/plasticity.hpp"

namespace rigor {

double von_mises_principal(double stress1, double stress2, double stress3)
{
    return stress1 - stress3;
}

} // namespace rigor
