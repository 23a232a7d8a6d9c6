// SPDX-License-Identifier: MIT
// A static body is known by its inverse mass, 0. Here its inverse inertia counts all the same.
#include "formulas/collision.hpp"

namespace rigor {

Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    const Vector3d r = x - X;
    Matrix3d K = inverse_mass * Matrix3d::Identity();
    for (int i = 0; i < 3; ++i)
        K.col(i) += (I_inverse * r.cross(Vector3d::Unit(i))).cross(r);
    return K;
}

} // namespace rigor
