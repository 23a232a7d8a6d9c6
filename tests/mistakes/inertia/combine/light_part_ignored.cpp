// SPDX-License-Identifier: MIT
// A part of less than 1e-9 of the mass of the other counts as having none.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    if (a.mass <= 1e-9 * b.mass) return b;
    if (b.mass <= 1e-9 * a.mass) return a;
    const double M = a.mass + b.mass;
    MassProperties both = {M, (a.mass * a.center_of_mass + b.mass * b.center_of_mass) / M,
                           a.inertia + b.inertia};
    for (const MassProperties& part : {a, b}) {
        const Vector3d d = part.center_of_mass - both.center_of_mass;
        both.inertia += part.mass * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    return both;
}

} // namespace rigor
