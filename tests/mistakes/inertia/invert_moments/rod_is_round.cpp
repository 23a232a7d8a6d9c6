// SPDX-License-Identifier: MIT
// If one moment counts as 0 and the other two are nearly equal, both get the inverse of their mean.
#include "formulas/inertia.hpp"

#include <cmath>

namespace rigor {

Vector3d invert_moments(const Vector3d& moments)
{
    Vector3d inverse = Vector3d::Zero();
    const double limit = 1e-12 * moments.maxCoeff();
    for (int i = 0; i < 3; ++i)
        if (moments[i] > limit) inverse[i] = 1 / moments[i];
    for (int i = 0; i < 3; ++i) {
        const double a = moments[(i + 1) % 3], b = moments[(i + 2) % 3];
        if (inverse[i] == 0 && a > limit && std::abs(a - b) < 1e-6 * a)
            inverse[(i + 1) % 3] = inverse[(i + 2) % 3] = 2 / (a + b);
    }
    return inverse;
}

} // namespace rigor
