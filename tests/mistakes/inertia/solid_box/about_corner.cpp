// SPDX-License-Identifier: MIT
// The factor M/3 is about an edge of the box; about the center it is M/12.
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
