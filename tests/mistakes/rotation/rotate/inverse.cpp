// SPDX-License-Identifier: MIT
// The product is q̄ (0, p) q, which is the inverse rotation.
#include "formulas/rotation.hpp"

namespace rigor {

Vector3d rotate(const Quaternion& q, const Vector3d& p)
{
    return multiply(multiply(conjugate(q), {0, p}), q).v;
}

} // namespace rigor
