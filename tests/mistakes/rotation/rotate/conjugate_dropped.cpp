// SPDX-License-Identifier: MIT
// The second factor is q, not its conjugate.
#include "formulas/rotation.hpp"

namespace rigor {

Vector3d rotate(const Quaternion& q, const Vector3d& p)
{
    return multiply(multiply(q, {0, p}), q).v;
}

} // namespace rigor
