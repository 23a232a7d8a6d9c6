// SPDX-License-Identifier: MIT
// The moment of a rod about its own axis is 0, and its inverse must be 0, not infinity.
#include "formulas/inertia.hpp"

namespace rigor {

Vector3d invert_moments(const Vector3d& moments)
{
    return moments.cwiseInverse();
}

} // namespace rigor
