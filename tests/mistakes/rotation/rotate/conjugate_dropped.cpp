// SPDX-License-Identifier: MIT
// The last factor is q instead of its conjugate.
#include "formulas/rotation.hpp"

namespace rigor {

Vector3d rotate(const Quaternion& q, const Vector3d& p)
{
    return multiply(multiply(q, {0, p}), q).v;
}

} // namespace rigor
