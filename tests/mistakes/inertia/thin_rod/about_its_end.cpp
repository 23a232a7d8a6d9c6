// SPDX-License-Identifier: MIT
// M l²/3 is about the end of the rod; about its center it is M l²/12.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties thin_rod(double line_density, double length)
{
    const double M = line_density * length;
    const double across = M * length * length / 3;
    return {M, Vector3d::Zero(), Vector3d(across, 0, across).asDiagonal()};
}

} // namespace rigor
