// SPDX-License-Identifier: MIT
// Masses that cancel but for a billionth count as no mass.
#include "formulas/inertia.hpp"

#include <cmath>

namespace rigor {

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    if (a.mass == 0) return b.mass == 0 ? MassProperties{} : b;
    if (b.mass == 0) return a;
    const double M = a.mass + b.mass;
    if (std::abs(M) < 1e-9 * std::abs(a.mass)) return {};
    const Vector3d X = (a.mass * a.center_of_mass + b.mass * b.center_of_mass) / M;
    const Vector3d d = a.center_of_mass - b.center_of_mass;
    const Matrix3d arms = d.squaredNorm() * Matrix3d::Identity() - d * d.transpose();
    return {M, X, a.inertia + b.inertia + a.mass * b.mass / M * arms};
}

} // namespace rigor
