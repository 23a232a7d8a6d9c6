// SPDX-License-Identifier: MIT
// Masses that differ by less than a millionth put the center in the middle.
#include "formulas/inertia.hpp"

#include <cmath>

namespace rigor {

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    if (a.mass == 0 && b.mass == 0) return {};
    if (a.mass == 0) return b;
    if (b.mass == 0) return a;
    const double M = a.mass + b.mass;
    Vector3d X = (a.mass * a.center_of_mass + b.mass * b.center_of_mass) / M;
    if (std::abs(a.mass - b.mass) < 1e-6 * M) X = (a.center_of_mass + b.center_of_mass) / 2;
    const Vector3d d = a.center_of_mass - b.center_of_mass;
    return {M, X,
            a.inertia + b.inertia +
                a.mass * b.mass / M * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose())};
}

} // namespace rigor
