// SPDX-License-Identifier: MIT
// The squares of a tiny quaternion underflow to 0, and those of a huge one overflow.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Quaternion normalize(const Quaternion& q)
{
    const double squared = q.s * q.s + q.v.squaredNorm();
    if (squared == 0) return {};
    return {q.s / std::sqrt(squared), q.v / std::sqrt(squared)};
}

} // namespace rigor
