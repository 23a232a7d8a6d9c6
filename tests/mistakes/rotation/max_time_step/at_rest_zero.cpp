// SPDX-License-Identifier: MIT
// A body at rest gets a time step of 0; it has no limit.
#include "formulas/rotation.hpp"

#include <numbers>

namespace rigor {

double max_time_step(const Vector3d& omega)
{
    const double speed = omega.norm();
    return speed == 0 ? 0 : std::numbers::pi / 2 / speed;
}

} // namespace rigor
