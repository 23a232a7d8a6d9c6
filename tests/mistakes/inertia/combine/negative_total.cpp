// SPDX-License-Identifier: MIT
// A negative total mass counts as none, although two meshes that are inside out have one.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    if (a.mass == 0 && b.mass == 0) return {};
    if (a.mass == 0) return b;
    if (b.mass == 0) return a;
    const double M = a.mass + b.mass;
    if (M <= 0) return {};
    const Vector3d d = a.center_of_mass - b.center_of_mass;
    return {M, (a.mass * a.center_of_mass + b.mass * b.center_of_mass) / M,
            a.inertia + b.inertia +
                a.mass * b.mass / M * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose())};
}

} // namespace rigor
