// SPDX-License-Identifier: MIT
// The threshold must be relative to the largest moment: all moments of a small body are small.
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
