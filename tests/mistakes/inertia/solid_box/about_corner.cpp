// SPDX-License-Identifier: MIT
// M/3 is the inertia about an edge: about the center it is M/12.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties solid_box(double density, const Vector3d& size)
{
    const double M = density * size.prod();
    const Vector3d s = size.cwiseProduct(size);
    const Vector3d I = M / 3 * Vector3d(s[1] + s[2], s[2] + s[0], s[0] + s[1]);
    return {M, Vector3d::Zero(), I.asDiagonal()};
}

} // namespace rigor
