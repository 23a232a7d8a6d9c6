// SPDX-License-Identifier: MIT
// The factors are swapped: the product is b a, with the wrong sign of the cross product.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion multiply(const Quaternion& a, const Quaternion& b)
{
    return {a.s * b.s - a.v.dot(b.v), a.s * b.v + b.s * a.v + b.v.cross(a.v)};
}

} // namespace rigor
