// SPDX-License-Identifier: MIT
// A thin box counts as a rod, which has no moment about its axis.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties solid_box(double density, const Vector3d& size)
{
    const double m = density * size.prod();
    const Vector3d q = size.cwiseAbs2();
    Vector3d moments = m / 12 * Vector3d(q.y() + q.z(), q.z() + q.x(), q.x() + q.y());
    for (int i = 0; i < 3; ++i)
        if (moments[i] < 1e-10 * moments.maxCoeff()) moments[i] = 0;
    return {m, Vector3d::Zero(), moments.asDiagonal()};
}

} // namespace rigor
