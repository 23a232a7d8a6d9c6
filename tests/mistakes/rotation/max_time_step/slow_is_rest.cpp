// SPDX-License-Identifier: MIT
// A body slower than 1e-6 rad/s counts as being at rest.
#include "formulas/rotation.hpp"

#include <limits>
#include <numbers>

namespace rigor {

double max_time_step(const Vector3d& omega)
{
    if (omega.norm() < 1e-6) return std::numeric_limits<double>::infinity();
    return std::numbers::pi / 2 / omega.norm();
}

} // namespace rigor
