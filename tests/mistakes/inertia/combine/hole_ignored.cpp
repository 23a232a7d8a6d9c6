// SPDX-License-Identifier: MIT
// A body of negative mass is no body without mass: it is a hole, and has to be taken out.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    if (a.mass <= 0) return b;
    if (b.mass <= 0) return a;
    const double M = a.mass + b.mass;
    const Vector3d X = (a.mass * a.center_of_mass + b.mass * b.center_of_mass) / M;
    const Vector3d d1 = a.center_of_mass - X, d2 = b.center_of_mass - X;
    const Matrix3d one = Matrix3d::Identity();
    return {M, X,
            a.inertia + a.mass * (d1.squaredNorm() * one - d1 * d1.transpose()) + b.inertia +
                b.mass * (d2.squaredNorm() * one - d2 * d2.transpose())};
}

} // namespace rigor
