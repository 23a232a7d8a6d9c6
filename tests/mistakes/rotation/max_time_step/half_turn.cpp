// SPDX-License-Identifier: MIT
// Half a turn is allowed per step; the limit is a quarter turn.
#include "formulas/rotation.hpp"

#include <numbers>

namespace rigor {

double max_time_step(const Vector3d& omega)
{
    return std::numbers::pi / omega.norm();
}

} // namespace rigor
