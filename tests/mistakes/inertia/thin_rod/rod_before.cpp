// SPDX-License-Identifier: MIT
// A rod without length is the rod of the call before.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties thin_rod(double line_density, double length)
{
    static MassProperties rod;
    if (length > 0) {
        const double M = line_density * length, I = M * length * length / 12;
        rod = {M, Vector3d::Zero(), Vector3d(I, 0, I).asDiagonal()};
    }
    return rod;
}

} // namespace rigor
