// SPDX-License-Identifier: MIT
// Centers nearer to each other than a millionth of their distance from the origin count as equal.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    if (a.mass == 0 && b.mass == 0) return {};
    if (a.mass == 0) return b;
    if (b.mass == 0) return a;
    const double M = a.mass + b.mass;
    const Vector3d X = (a.mass * a.center_of_mass + b.mass * b.center_of_mass) / M;
    const Vector3d d = a.center_of_mass - b.center_of_mass;
    Matrix3d I = a.inertia + b.inertia;
    if (!a.center_of_mass.isApprox(b.center_of_mass, 1e-6))
        I += a.mass * b.mass / M * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    return {M, X, I};
}

} // namespace rigor
