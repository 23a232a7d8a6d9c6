// SPDX-License-Identifier: MIT
// A moment is compared with the last one, which need not be the largest.
#include "formulas/inertia.hpp"

namespace rigor {

Vector3d invert_moments(const Vector3d& moments)
{
    Vector3d inverse = Vector3d::Zero();
    const double largest = moments[2] > 0 ? moments[2] : moments.maxCoeff();
    for (int i = 0; i < 3; ++i)
        if (moments[i] > 1e-12 * largest) inverse[i] = 1 / moments[i];
    return inverse;
}

} // namespace rigor
