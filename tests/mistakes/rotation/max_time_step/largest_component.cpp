// SPDX-License-Identifier: MIT
// The largest component of ω is used instead of its length.
#include "formulas/rotation.hpp"

#include <numbers>

namespace rigor {

double max_time_step(const Vector3d& omega)
{
    return std::numbers::pi / 2 / omega.cwiseAbs().maxCoeff();
}

} // namespace rigor
