// SPDX-License-Identifier: MIT
// The product is b a: the cross product has the wrong sign.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion multiply(const Quaternion& a, const Quaternion& b)
{
    return {a.s * b.s - a.v.dot(b.v), a.s * b.v + b.s * a.v + b.v.cross(a.v)};
}

} // namespace rigor
