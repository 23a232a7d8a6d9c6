// SPDX-License-Identifier: MIT
// q is divided by |q|² instead of |q|.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion normalize(const Quaternion& q)
{
    const double squared = q.s * q.s + q.v.squaredNorm();
    if (squared == 0) return {};
    return {q.s / squared, q.v / squared};
}

} // namespace rigor
