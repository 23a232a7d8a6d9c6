// SPDX-License-Identifier: MIT
// The scalar part is negated instead of the vector part.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion conjugate(const Quaternion& q)
{
    return {-q.s, q.v};
}

} // namespace rigor
