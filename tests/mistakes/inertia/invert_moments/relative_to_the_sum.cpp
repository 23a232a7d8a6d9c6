// SPDX-License-Identifier: MIT
// A moment is compared with the sum of all moments instead of the largest.
#include "formulas/inertia.hpp"

namespace rigor {

Vector3d invert_moments(const Vector3d& moments)
{
    Vector3d inverse = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        if (moments[i] > 1e-12 * moments.sum()) inverse[i] = 1 / moments[i];
    return inverse;
}

} // namespace rigor
