// SPDX-License-Identifier: MIT
// A normal velocity below a billionth of the speed counts as none.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double v_n = v.dot(n), nKn = n.dot(K * n);
    if (nKn == 0 || std::abs(v_n) < 1e-9 * v.norm()) return Vector3d::Zero();
    return -(1 + restitution) * v_n / nKn * n;
}

} // namespace rigor
