// SPDX-License-Identifier: MIT
// A box whose edges differ by less than 1e-8 is taken for a cube.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties solid_box(double density, const Vector3d& size)
{
    const double M = density * size.prod();
    Vector3d s = size.cwiseProduct(size);
    if (size.maxCoeff() - size.minCoeff() < 1e-8 * size.maxCoeff()) s.setConstant(s.mean());
    const Vector3d I = M / 12 * Vector3d(s[1] + s[2], s[2] + s[0], s[0] + s[1]);
    return {M, Vector3d::Zero(), I.asDiagonal()};
}

} // namespace rigor
